// STEP files written by hand.
//   StepText       collects entities; `file` is the whole text around them
#pragma once

#include <string>
#include <vector>

namespace torse::testing {

/// Entities #1, #2, ... of one file. The unit is that of the only context.
class StepText {
 public:
  /// `unit` is "mm", "m" or "inch", or empty for none.
  explicit StepText(const std::string& unit = "mm") {
    if (unit.empty()) {
      context_ = add("(GEOMETRIC_REPRESENTATION_CONTEXT(3) REPRESENTATION_CONTEXT('',''))");
      return;
    }
    const std::string metric = unit == "m" ? "SI_UNIT($,.METRE.)" : "SI_UNIT(.MILLI.,.METRE.)";
    std::string length = add("(LENGTH_UNIT() NAMED_UNIT(*) " + metric + ")");
    if (unit == "inch") {
      const std::string measure = add("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4)," + length + ")");
      const std::string dimension = add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)");
      length = add("(CONVERSION_BASED_UNIT('INCH'," + measure + ") LENGTH_UNIT() NAMED_UNIT(" + dimension + "))");
    }
    const std::string angle = add("(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))");
    const std::string solid = add("(NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT())");
    const std::string tolerance =
        add("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-06)," + length + ",'distance_accuracy_value','')");
    context_ = add("(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((" + tolerance +
                   ")) GLOBAL_UNIT_ASSIGNED_CONTEXT((" + length + "," + angle + "," + solid +
                   ")) REPRESENTATION_CONTEXT('',''))");
  }

  /// Adds an entity and returns its name.
  std::string add(const std::string& entity) {
    text_ += "#" + std::to_string(++count_) + "=" + entity + ";\n";
    return "#" + std::to_string(count_);
  }
  std::string point(const std::string& xyz) { return add("CARTESIAN_POINT('',(" + xyz + "))"); }
  std::string direction(const std::string& xyz) { return add("DIRECTION('',(" + xyz + "))"); }
  std::string frame(const std::string& origin, const std::string& z, const std::string& x) {
    return add("AXIS2_PLACEMENT_3D(''," + point(origin) + "," + direction(z) + "," + direction(x) + ")");
  }
  /// A parenthesised list of rows of points.
  std::string net(const std::vector<std::vector<std::string>>& rows) {
    std::string text;
    for (const auto& row : rows) {
      std::string line;
      for (const std::string& xyz : row) line += (line.empty() ? "" : ",") + point(xyz);
      text += (text.empty() ? "(" : ",(") + line + ")";
    }
    return "(" + text + ")";
  }
  /// B_SPLINE_SURFACE_WITH_KNOTS; `knots` is "(u multiplicities),(v multiplicities),(u knots),(v knots)".
  std::string spline(const std::string& name, int u, int v, const std::vector<std::vector<std::string>>& rows,
                     const std::string& knots) {
    return add("B_SPLINE_SURFACE_WITH_KNOTS('" + name + "'," + std::to_string(u) + "," + std::to_string(v) + "," +
               net(rows) + ",.UNSPECIFIED.,.F.,.F.,.F.," + knots + ",.UNSPECIFIED.)");
  }
  /// The rational kind; `weights` is "((...),(...))".
  std::string rational(const std::string& name, int u, int v, const std::vector<std::vector<std::string>>& rows,
                       const std::string& knots, const std::string& weights) {
    return add("(BOUNDED_SURFACE() B_SPLINE_SURFACE(" + std::to_string(u) + "," + std::to_string(v) + "," + net(rows) +
               ",.UNSPECIFIED.,.F.,.F.,.F.) B_SPLINE_SURFACE_WITH_KNOTS(" + knots +
               ",.UNSPECIFIED.) GEOMETRIC_REPRESENTATION_ITEM() RATIONAL_B_SPLINE_SURFACE(" + weights +
               ") REPRESENTATION_ITEM('" + name + "') SURFACE())");
  }
  /// A face of straight edges through these corners, in order.
  std::string face(const std::string& name, const std::string& surface, const std::vector<std::string>& corners) {
    std::vector<std::string> vertices;
    for (const std::string& xyz : corners) vertices.push_back(add("VERTEX_POINT(''," + point(xyz) + ")"));
    std::string edges;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::string line =
          add("POLYLINE('',(" + point(corners[i]) + "," + point(corners[(i + 1) % corners.size()]) + "))");
      const std::string edge =
          add("EDGE_CURVE(''," + vertices[i] + "," + vertices[(i + 1) % corners.size()] + "," + line + ",.T.)");
      edges += (edges.empty() ? "" : ",") + add("ORIENTED_EDGE('',*,*," + edge + ",.T.)");
    }
    const std::string bound = add("FACE_OUTER_BOUND(''," + add("EDGE_LOOP('',(" + edges + "))") + ",.T.)");
    return add("ADVANCED_FACE('" + name + "',(" + bound + ")," + surface + ",.T.)");
  }

  /// The file with one shape of these items: faces in a shell, or surfaces in a set.
  std::string file(const std::vector<std::string>& items, bool faces) {
    std::string list;
    for (const std::string& item : items) list += (list.empty() ? "" : ",") + item;
    const std::string model = faces
                                  ? add("SHELL_BASED_SURFACE_MODEL('',(" + add("OPEN_SHELL('',(" + list + "))") + "))")
                                  : add("GEOMETRIC_SET('',(" + list + "))");
    const std::string shape = add((faces ? "MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',("
                                         : "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION('',(") +
                                  model + ")," + context_ + ")");
    product(shape);
    return whole();
  }

  /// The same faces at these places of an assembly.
  std::string assembly(const std::vector<std::string>& faces, const std::vector<std::string>& places) {
    std::string list;
    for (const std::string& face : faces) list += (list.empty() ? "" : ",") + face;
    const std::string own = frame("0.,0.,0.", "0.,0.,1.", "1.,0.,0.");
    const std::string shell = add("SHELL_BASED_SURFACE_MODEL('',(" + add("OPEN_SHELL('',(" + list + "))") + "))");
    const std::string part =
        add("MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(" + own + "," + shell + ")," + context_ + ")");
    std::string frames = own;
    for (const std::string& place : places) frames += "," + place;
    const std::string whole_shape = add("SHAPE_REPRESENTATION('',(" + frames + ")," + context_ + ")");
    const std::string child = product(part);
    const std::string parent = product(whole_shape);
    for (const std::string& place : places) {
      const std::string map = add("ITEM_DEFINED_TRANSFORMATION('',''," + own + "," + place + ")");
      const std::string relation =
          add("(REPRESENTATION_RELATIONSHIP('',''," + part + "," + whole_shape +
              ") REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(" + map + ") SHAPE_REPRESENTATION_RELATIONSHIP())");
      const std::string use =
          add("NEXT_ASSEMBLY_USAGE_OCCURRENCE('" + place + "','',''," + parent + "," + child + ",$)");
      add("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(" + relation + "," +
          add("PRODUCT_DEFINITION_SHAPE('',''," + use + ")") + ")");
    }
    return whole();
  }

  /// Ties a representation to a product of its own.
  std::string product(const std::string& shape) {
    const std::string application = add("APPLICATION_CONTEXT('automotive design')");
    const std::string context = add("PRODUCT_CONTEXT(''," + application + ",'mechanical')");
    const std::string formation =
        add("PRODUCT_DEFINITION_FORMATION('',''," + add("PRODUCT('part','part','',(" + context + "))") + ")");
    const std::string definition =
        add("PRODUCT_DEFINITION('design',''," + formation + "," +
            add("PRODUCT_DEFINITION_CONTEXT('part definition'," + application + ",'design')") + ")");
    const std::string of_product = add("PRODUCT_DEFINITION_SHAPE('',''," + definition + ")");
    add("SHAPE_DEFINITION_REPRESENTATION(" + of_product + "," + shape + ")");
    return definition;
  }

  const std::string& context() const { return context_; }

  /// The text of all entities so far as a file.
  std::string whole() const {
    return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
           "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n" +
           text_ + "ENDSEC;\nEND-ISO-10303-21;\n";
  }

 private:
  int count_ = 0;
  std::string text_;
  std::string context_;
};

}  // namespace torse::testing
