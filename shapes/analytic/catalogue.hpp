#pragma once

#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "shapes/analytic/parameters.hpp"
#include "shapes/analytic/shape.hpp"

namespace gridstep {

template <int d>
using ShapeFactory =
    std::function<std::unique_ptr<Shape<d>>(const ParameterValues&, const RealPoint<d>& centre)>;

/// A line of the catalogue: what `gridstep list shapes` shows and how a shape is made.
struct ShapeEntry {
  std::string name;
  std::string summary;  ///< the defining equation, in the letters of `parameters`
  std::vector<Parameter>
      parameters;  ///< without the centre (cx, cy, cz), which the catalogue adds to every shape
  std::variant<ShapeFactory<2>, ShapeFactory<3>> make;

  int dimension() const { return make.index() == 0 ? 2 : 3; }
};

/// All shapes, in the order of shapes/analytic/catalogue.inc.
const std::vector<ShapeEntry>& shape_catalogue();

/// @throws InputError naming an unknown shape and listing the known ones.
const ShapeEntry& find_shape(const std::string& name);

using AnyShape = std::variant<std::shared_ptr<const Shape<2>>, std::shared_ptr<const Shape<3>>>;

/// @throws InputError naming the shape, the parameter and the value that is wrong.
AnyShape make_shape(const ShapeSpec& spec);

/// For callers that know the dimension; @throws InputError where the shape has the other one.
template <int d>
std::shared_ptr<const Shape<d>> make_shape(const std::string& spec);

}  // namespace gridstep
