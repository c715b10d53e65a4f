#pragma once
// What the loader throws and notes while it reads a file.

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace crsh::scene {

/// Why a glTF file cannot be drawn. load() puts the file's name before it and makes a UserError of it.
class Fault : public std::runtime_error {
 public:
  explicit Fault(const std::string& reason, std::string mend = "export the scene again")
      : std::runtime_error(reason), mend_(std::move(mend)) {}
  [[nodiscard]] const std::string& mend() const { return mend_; }

 private:
  std::string mend_;
};

/// A file names another that lies outside its own folder.
class OutsideFault : public Fault {
 public:
  explicit OutsideFault(const std::string& name = {})
      : Fault(name + "lies outside the scene's folder", "put it beside the scene, or allow it explicitly") {}
};

/// Too much to be drawn, whatever part of the file asks for it.
class LimitFault : public Fault {
 public:
  LimitFault() : Fault("is too large to be drawn", "simplify the scene") {}
};

/// A file requires extensions that crsh does not do.
class NeedsExtensions : public Fault {
 public:
  explicit NeedsExtensions(const std::string& reason)
      : Fault(reason, "export the scene without, or draw the rest of it") {}
};

/// Text from a file, made fit for one line of a terminal: no control characters, no more than `limit` bytes.
[[nodiscard]] std::string printable(std::string_view text, size_t limit = 120);

/// The same in single quotes.
[[nodiscard]] std::string in_quotes(std::string_view text, size_t limit = 120);

/// Short clauses about what the file asks for and crsh does not do, each once.
class Notes {
 public:
  explicit Notes(std::vector<std::string>& list) : list_(list) {}
  void add(std::string_view clause);

  /// Runs `read`. Where it ends with a Fault, what stands at `where` in the file is left out, with a note; limits and
  /// files out of reach are no single part's fault, and go on.
  template <class Read>
  void attempt(const std::string& where, Read read) {
    try {
      read();
    } catch (const LimitFault&) {
      throw;
    } catch (const OutsideFault&) {
      throw;
    } catch (const Fault& fault) {
      leave_out(where, fault);
    }
  }
  void leave_out(const std::string& where, const Fault& fault);
  /// The first of those: why there is nothing to draw, where there is nothing.
  [[nodiscard]] const std::optional<Fault>& first_fault() const { return first_fault_; }

 private:
  std::vector<std::string>& list_;
  std::optional<Fault> first_fault_;
};

}  // namespace crsh::scene
