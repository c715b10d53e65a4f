#include "viewer/window.h"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>

#include <filesystem>

#include "crsh/error.h"
#include "viewer/style.h"

namespace crsh::viewer {
namespace {

std::string glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason is given";
}

/// The character that a key has in the person's layout: W, A, S and D are letters, not places on the keyboard.
int key_of(int key, int scancode) {
  const char* name = glfwGetKeyName(key, scancode);
  if (!name || name[0] == 0 || name[1] != 0 || (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_EQUAL)) return key;
  const char c = name[0];
  return c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c >= '0' && c <= '9' ? c : key;
}

void set_pointer(const ScriptedPointer& pointer) {
  ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM >= 18700
  io.AddMousePosEvent(pointer.place.x, pointer.place.y);
  for (int button = 0; button < 3; ++button) io.AddMouseButtonEvent(button, pointer.down[button]);
  if (pointer.wheel != 0) io.AddMouseWheelEvent(0, pointer.wheel);
  io.AddKeyEvent(ImGuiMod_Shift, pointer.shift);
#else
  io.MousePos = {pointer.place.x, pointer.place.y};
  for (int button = 0; button < 3; ++button) io.MouseDown[button] = pointer.down[button];
  io.MouseWheel = pointer.wheel;
  io.KeyShift = pointer.shift;
#endif
}

}  // namespace

WindowSystem::WindowSystem() {
  if (!glfwInit())
    throw UserError("no window can be opened: " + glfw_error() +
                    "; on a machine without a display, crsh render makes pictures");
  if (!glfwVulkanSupported()) {
    glfwTerminate();
    throw UserError(
        "there is no Vulkan device: install a driver (the Debian package mesa-vulkan-drivers has one that needs no "
        "GPU)",
        Exit::no_device);
  }
}

WindowSystem::~WindowSystem() { glfwTerminate(); }

std::vector<std::string> WindowSystem::extensions() const {
  uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (!names) throw UserError("Vulkan cannot draw to windows here: " + glfw_error());
  return {names, names + count};
}

void WindowSystem::wake() { glfwPostEmptyEvent(); }

void Window::CloseWindow::operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }

Window::ImguiContext::ImguiContext(GLFWwindow* window, float scale) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // writes no file of settings
#if IMGUI_VERSION_NUM >= 18700
  io.ConfigInputTrickleEventQueue = false;
#endif
  set_style(scale);
  ImGui_ImplGlfw_InitForVulkan(window, true);
}

Window::ImguiContext::~ImguiContext() {
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

Window::Window(gpu::Device& device, const std::string& title, int width, int height) : device_(device) {
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "crsh-view");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "crsh-view");
  window_.reset(glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr));
  if (!window_) throw UserError("no window can be opened: " + glfw_error());
  float scale_y = 1;
  glfwGetWindowContentScale(window_.get(), &text_scale_, &scale_y);
  listen();
  surface_ = std::make_unique<gpu::Surface>(device, [this](VkInstance instance, VkSurfaceKHR* surface) {
    return glfwCreateWindowSurface(instance, window_.get(), nullptr, surface);
  });
  swapchain_ = std::make_unique<gpu::Swapchain>(device, *surface_);
  imgui_ = std::make_unique<ImguiContext>(window_.get(), text_scale_);
  backend_ = std::make_unique<gpu::ImguiBackend>(device, *swapchain_);
}

Window::~Window() = default;

void Window::listen() {
  GLFWwindow* window = window_.get();
  glfwSetWindowUserPointer(window, this);
  glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int scancode, int action, int mods) {
    if (action != GLFW_PRESS) return;
    static_cast<Window*>(glfwGetWindowUserPointer(from))
        ->keys_.push_back({key_of(key, scancode), (mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_CONTROL) != 0});
  });
  glfwSetDropCallback(window, [](GLFWwindow* from, int count, const char** paths) {
    if (count > 0) static_cast<Window*>(glfwGetWindowUserPointer(from))->drops_.emplace_back(paths[0]);
  });
}

void Window::wait(double seconds) { seconds > 0 ? glfwWaitEventsTimeout(seconds) : glfwPollEvents(); }
bool Window::closing() const { return glfwWindowShouldClose(window_.get()); }
std::vector<KeyPress> Window::take_keys() { return std::exchange(keys_, {}); }
std::vector<std::string> Window::take_drops() { return std::exchange(drops_, {}); }

bool Window::is_down(int key) const {
  if (held_ == key) return true;
  for (int place = GLFW_KEY_A; place <= GLFW_KEY_Z; ++place)
    if (key_of(place, 0) == key) return glfwGetKey(window_.get(), place) == GLFW_PRESS;
  return glfwGetKey(window_.get(), key) == GLFW_PRESS;
}

bool Window::shift() const { return ImGui::GetIO().KeyShift || scripted_shift_; }

void Window::begin_frame(const ScriptedPointer* pointer) {
  backend_->begin_frame();
  ImGui_ImplGlfw_NewFrame();
  scripted_shift_ = pointer && pointer->shift;
  if (pointer) set_pointer(*pointer);
  ImGui::NewFrame();
}

bool Window::end_frame(std::vector<gpu::ShownTexture> textures, gpu::Screenshot* screenshot) {
  ImGui::Render();
  const glm::ivec2 size = pixels();
  if (size.x == 0 || size.y == 0 || minimised()) return false;
  const auto record = [this](VkCommandBuffer commands) { backend_->record(commands); };
  return swapchain_->draw({uint32_t(size.x), uint32_t(size.y), std::move(textures), record}, screenshot);
}

glm::vec2 Window::pixel_scale() const {
  int width = 0, height = 0;
  glfwGetWindowSize(window_.get(), &width, &height);
  const glm::ivec2 size = pixels();
  return width > 0 && height > 0 ? glm::vec2(size) / glm::vec2(width, height) : glm::vec2(1);
}

glm::ivec2 Window::pixels() const {
  glm::ivec2 size(0);
  glfwGetFramebufferSize(window_.get(), &size.x, &size.y);
  return size;
}

void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_.get(), title.c_str()); }
void Window::set_size(int width, int height) { glfwSetWindowSize(window_.get(), width, height); }
void Window::minimise() { glfwIconifyWindow(window_.get()); }
void Window::restore() { glfwRestoreWindow(window_.get()); }
bool Window::minimised() const { return glfwGetWindowAttrib(window_.get(), GLFW_ICONIFIED); }
void Window::copy(const std::string& text) { glfwSetClipboardString(window_.get(), text.c_str()); }

}  // namespace crsh::viewer
