#pragma once
// What the objects of a glTF file hold, as far as crsh reads them: one table. What it does not name is never looked at.

#include <cstdint>
#include <span>
#include <string_view>

namespace crsh::scene {

/// What a field holds.
enum class Kind {
  index,    ///< a whole number below 2^31: a place in a list, or one of glTF's codes
  length,   ///< a whole number up to 2^40: bytes or elements
  number,   ///< finite
  numbers,  ///< an array of `count` finite numbers; 0: of any number of them
  flag,
  text,
  indices,  ///< an array of them
  texts,    ///< an array of them
  object,   ///< of `shape`
  list      ///< an array of objects of `shape`
};

struct Shape;

struct Field {
  std::string_view name;  ///< with a * at its end: all that begin with what is before it
  Kind kind;
  size_t count = 0;
  const Shape* shape = nullptr;
  bool needed = false;             ///< a Fault where it is missing
  std::string_view stand_in = {};  ///< of a list: the JSON put in place of an element that is broken; empty: a Fault
  std::string_view fill = {};      ///< the JSON put in where it is missing, because tinygltf would refuse the file
};

struct Shape {
  std::span<const Field> fields;
  size_t bytes = 0;  ///< what tinygltf makes of one in a list takes about so much memory
};

/// What stands in for a broken accessor and a broken camera: nothing reads it.
inline constexpr std::string_view accessor_stand_in = R"({"componentType":5126,"count":0,"type":"SCALAR"})";
inline constexpr std::string_view camera_stand_in = R"({"type":"perspective","perspective":{"yfov":1.0,"znear":1.0}})";

/// The whole file's.
extern const Shape root_shape;

}  // namespace crsh::scene
