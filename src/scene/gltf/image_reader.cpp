#include "scene/gltf/image_reader.h"

#include <utility>

#include "scene/gltf/fault.h"

namespace crsh::scene {

namespace {

/// Images of one file may take this many texels together; more are drawn without (2 GiB).
constexpr uint64_t max_texels = uint64_t{1} << 29u;
/// Files of their own are kept until they are decoded, up to so many bytes.
constexpr uint64_t max_bytes_waiting = uint64_t{1} << 28u;

std::string named(const std::string& name, const std::string& reason) {
  return name.empty() ? reason : name + " " + reason;
}

}  // namespace

/// Its bytes, read by one thread: the document's buffers are shared.
void ImageReader::find_bytes(Entry& entry, int index) {
  const ImageSource& source = document_.image(index);
  if (source.view) {
    entry.bytes = document_.view(static_cast<int64_t>(*source.view));
    return;
  }
  if (source.uri.empty()) throw Fault("has no data");
  entry.own = document_.read(source.uri);
  entry.bytes = entry.own;
  entry.name = uri_name(source.uri);
}

/// What its head says: whether there is room for it depends on the file alone, not on what is decoded when.
void ImageReader::open(Entry& entry, int index) {
  try {
    find_bytes(entry, index);
    entry.size = image_size(entry.bytes);
    if (texels_ + entry.size.texels() > max_texels) throw Fault("and those before it take more than 2 GiB");
  } catch (const FormatFault& fault) {
    entry.verdict = {named(entry.name, fault.what()), true};
    return;
  } catch (const Fault& fault) {
    entry.verdict = {named(entry.name, fault.what())};
    return;
  }
  texels_ += entry.size.texels();
  bytes_waiting_ += entry.own.size();
  entry.wanted = true;
}

ImageReader::Entry& ImageReader::entry(int index) {
  const auto [found, fresh] = entries_.try_emplace(index);
  if (fresh) open(found->second, index);
  if (bytes_waiting_ > max_bytes_waiting) decode_wanted();
  return found->second;
}

bool ImageReader::want(int index) {
  const Entry& own = entry(index);
  return own.wanted || own.picture || own.place;
}

void ImageReader::decode_wanted() {
  std::vector<Entry*> wanted;
  std::vector<EncodedImage> encoded;
  for (auto& [index, entry] : entries_)
    if (std::exchange(entry.wanted, false)) {
      wanted.push_back(&entry);
      encoded.push_back({entry.bytes, entry.size});
    }
  std::vector<Decoding> decoded = decode_images(encoded);
  for (size_t i = 0; i < wanted.size(); ++i) {
    Entry& entry = *wanted[i];
    const std::string reason = decoded[i].picture ? decoded[i].picture->remark : decoded[i].fault;
    if (!reason.empty()) entry.verdict = {named(entry.name, reason)};
    if (decoded[i].picture) entry.picture = std::move(decoded[i].picture->image);
    entry.own = {};
  }
  bytes_waiting_ = 0;
}

std::optional<uint32_t> ImageReader::read(int index, std::vector<Image>& images) {
  Entry& own = entry(index);
  if (own.wanted) decode_wanted();
  if (own.picture) {
    own.place = static_cast<uint32_t>(images.size());
    images.push_back(*std::exchange(own.picture, std::nullopt));
  }
  return own.place;
}

}  // namespace crsh::scene
