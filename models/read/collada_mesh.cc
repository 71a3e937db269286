#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "models/read/collada_parts.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

class MeshCheck {
 public:
  explicit MeshCheck(std::string file) : file_(std::move(file)) {}

  void Run(const TiXmlElement& mesh) {
    static const std::set<std::string> primitives{"triangles", "polylist", "polygons", "trifans",
                                                  "tristrips"};
    for (const TiXmlElement* e = mesh.FirstChildElement(); e; e = e->NextSiblingElement()) {
      const std::string name = e->Value();
      if (name == "source") {
        TakeSource(*e);
      } else if (name == "vertices") {
        TakeVertices(*e);
      } else if (primitives.count(name) > 0) {
        CheckPrimitives(*e, name);
      } else {
        Refuse(*e, "expected sources, vertices and faces in a mesh");
      }
    }
  }

 private:
  [[noreturn]] void Refuse(const TiXmlElement& at, const std::string& what) const {
    RefuseElement(file_, at, what);
  }
  static std::string Attribute(const TiXmlElement& element, const char* name) {
    const char* text = element.Attribute(name);
    return text == nullptr ? "" : text;
  }
  /// An address within the document: "#name" -> "name".
  std::string Address(const TiXmlElement& element) const {
    const std::string text = Attribute(element, "source");
    if (text.size() < 2 || text[0] != '#') Refuse(element, "source: expected '#' and a name");
    return text.substr(1);
  }
  void TakeId(const TiXmlElement& element, const std::string& id) {
    if (id.empty()) Refuse(element, "missing attribute 'id'");
    if (!ids_.insert(id).second) Refuse(element, "id '" + id + "' is given twice");
  }

  void TakeSource(const TiXmlElement& source) {
    const std::string id = Attribute(source, "id");
    TakeId(source, id);
    std::map<std::string, long> arrays;
    for (const TiXmlElement* e = source.FirstChildElement(); e; e = e->NextSiblingElement()) {
      const std::string name = e->Value();
      if (name == "float_array") {
        TakeId(*e, Attribute(*e, "id"));
        arrays[Attribute(*e, "id")] = CountNumbers(*e);
      } else if (name == "technique_common" && counts_.count(id) == 0) {
        const TiXmlElement* accessor = e->FirstChildElement();
        if (accessor == nullptr || std::string_view(accessor->Value()) != "accessor" ||
            accessor->NextSiblingElement() != nullptr) {
          Refuse(*e, "expected one <accessor>");
        }
        counts_[id] = CheckAccessor(*accessor, arrays);
      } else {
        Refuse(*e, "expected a <float_array> and then one <technique_common> in a source");
      }
    }
    if (counts_.count(id) == 0) Refuse(source, "missing <technique_common>");
  }

  long CountNumbers(const TiXmlElement& array) const {
    const long count = CountOf(file_, array, "count");
    std::string_view text = TextOf(file_, array);
    long found = 0;
    for (std::string_view word = TakeWord(text); !word.empty(); word = TakeWord(text)) {
      double value = 0.0;
      if (!ParseNumber(word, value)) {
        Refuse(array, "expected numbers, found '" + std::string(word.substr(0, 40)) + "'");
      }
      ++found;
    }
    if (found != count) {
      Refuse(array, "count: expected " + std::to_string(found) + ", as many as there are numbers");
    }
    return count;
  }

  /// How many elements the accessor has; all lie in its array.
  long CheckAccessor(const TiXmlElement& accessor,
                     const std::map<std::string, long>& arrays) const {
    const auto array = arrays.find(Address(accessor));
    if (array == arrays.end())
      Refuse(accessor, "source: expected the id of a <float_array> before");
    const long count = CountOf(file_, accessor, "count");
    const long stride = CountOf(file_, accessor, "stride", 1);
    const long offset = CountOf(file_, accessor, "offset", 0);
    long params = 0;
    for (const TiXmlElement* e = accessor.FirstChildElement(); e; e = e->NextSiblingElement()) {
      if (std::string_view(e->Value()) != "param" || e->FirstChild() != nullptr || ++params > 4) {
        Refuse(*e, "expected at most 4 empty <param> in an accessor");
      }
      if (Attribute(*e, "type") == "float4x4") Refuse(*e, "type: expected float");
    }
    const long width = std::max({1L, stride, params});
    if (count > 0 && offset + (count - 1) * stride + width > array->second) {
      Refuse(accessor, "count, stride and offset: expected all within the array's " +
                           std::to_string(array->second) + " numbers");
    }
    return count;
  }

  /// How many elements an <input> offers.
  long CountOfInput(const TiXmlElement& input) const {
    if (input.FirstChild() != nullptr) Refuse(input, "expected an empty element");
    const auto source = counts_.find(Address(input));
    if (source == counts_.end()) Refuse(input, "source: expected the id of a <source> before");
    return source->second;
  }

  void TakeVertices(const TiXmlElement& vertices) {
    if (!vertices_id_.empty()) Refuse(vertices, "given twice in one mesh");
    vertices_id_ = Attribute(vertices, "id");
    TakeId(vertices, vertices_id_);
    bool has_positions = false;
    for (const TiXmlElement* e = vertices.FirstChildElement(); e; e = e->NextSiblingElement()) {
      if (std::string_view(e->Value()) != "input") Refuse(*e, "expected an <input>");
      const long count = CountOfInput(*e);
      vertex_count_ = has_positions ? std::min(vertex_count_, count) : count;
      if (!has_positions && Attribute(*e, "semantic") != "POSITION") {
        Refuse(*e, "semantic: expected POSITION first");
      }
      has_positions = true;
    }
    if (!has_positions) Refuse(vertices, "missing <input semantic=\"POSITION\">");
  }

  /// For each offset of an index list, how many elements the indices there may name.
  std::vector<long> IndexLimits(const TiXmlElement& faces) const {
    constexpr long kMost = 64, kNone = 1000000000;
    std::vector<long> limits;
    int vertices = 0;
    for (const TiXmlElement* e = faces.FirstChildElement("input"); e;
         e = e->NextSiblingElement("input")) {
      const long offset = CountOf(file_, *e, "offset", 0);
      if (offset >= kMost) Refuse(*e, "offset: expected less than 64");
      if (CountOf(file_, *e, "set", 0) > kMost) Refuse(*e, "set: expected at most 64");
      const bool vertex = Attribute(*e, "semantic") == "VERTEX";
      if (vertex && (Address(*e) != vertices_id_ || e->FirstChild() != nullptr)) {
        Refuse(*e, "source: expected the id of this mesh's <vertices>");
      }
      vertices += vertex ? 1 : 0;
      if (limits.size() <= static_cast<std::size_t>(offset)) {
        limits.resize(static_cast<std::size_t>(offset) + 1, kNone);
      }
      long& limit = limits[static_cast<std::size_t>(offset)];
      limit = std::min(limit, vertex ? vertex_count_ : CountOfInput(*e));
    }
    if (vertices != 1) Refuse(faces, "expected one <input semantic=\"VERTEX\">");
    return limits;
  }

  /// How many corners the list has; every index names an element.
  long CountCorners(const TiXmlElement& list, const std::vector<long>& limits) const {
    std::string_view text = TextOf(file_, list);
    std::size_t found = 0;
    for (std::string_view word = TakeWord(text); !word.empty(); word = TakeWord(text)) {
      const long index = WholeNumber(word);
      const long limit = limits[found++ % limits.size()];
      if (index < 0 || index >= limit) {
        Refuse(list, "expected indices from 0 to " + std::to_string(limit - 1) + ", found '" +
                         std::string(word.substr(0, 40)) + "'");
      }
    }
    if (found % limits.size() != 0) {
      Refuse(list, "expected " + std::to_string(limits.size()) + " indices for each corner");
    }
    return static_cast<long>(found / limits.size());
  }

  /// The corners that the faces of a <polylist> have together.
  long SumOfCorners(const TiXmlElement& vcount, long faces) const {
    std::string_view text = TextOf(file_, vcount);
    long sum = 0, found = 0;
    for (std::string_view word = TakeWord(text); !word.empty(); word = TakeWord(text), ++found) {
      const long corners = WholeNumber(word);
      if (corners < 1 || corners > 100000) Refuse(vcount, "expected corners from 1 to 100000");
      sum += corners;
    }
    if (found != faces) Refuse(vcount, "expected as many numbers as count says");
    return sum;
  }

  void CheckPrimitives(const TiXmlElement& faces, const std::string& kind) const {
    const long count = CountOf(file_, faces, "count");
    const std::vector<long> limits = IndexLimits(faces);
    long expected = kind == "triangles" ? 3 * count : 0, lists = 0;
    std::string last = "input";
    for (const TiXmlElement* e = faces.FirstChildElement(); e; e = e->NextSiblingElement()) {
      const std::string name = e->Value();
      const bool in_order = name == "p"        ? kind != "polylist" || last != "input"
                            : name == "vcount" ? kind == "polylist" && last == "input"
                                               : name == "input" && last == "input";
      if (!in_order) Refuse(*e, "expected <input>s, then for a polylist <vcount>, then <p>");
      last = name;
      if (name == "vcount") expected = SumOfCorners(*e, count);
      if (name != "p") continue;
      const long corners = CountCorners(*e, limits);
      ++lists;
      const bool whole = kind == "triangles" || kind == "polylist";
      if (whole ? lists > 1 || corners != expected : corners < 3) {
        Refuse(*e, whole ? "expected one list of " + std::to_string(expected) + " corners, found " +
                               std::to_string(corners)
                         : "expected at least 3 corners");
      }
    }
    const bool one_each = kind == "polygons" || kind == "trifans" || kind == "tristrips";
    if (one_each && lists != count) Refuse(faces, "count: expected as many as there are <p>");
  }

  std::string file_;
  std::set<std::string> ids_;
  std::map<std::string, long> counts_;  // elements of each source
  std::string vertices_id_;
  long vertex_count_ = 0;
};

}  // namespace

void CheckColladaMesh(const std::string& file, const TiXmlElement& mesh) {
  MeshCheck(file).Run(mesh);
}

}  // namespace dockyard
