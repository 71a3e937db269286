// The data of a report as the page reads them: blobs behind a header of JSON, packed into text
// (docs/reference/report_payload.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/base/json.h"

namespace dockyard {

class Payload {
 public:
  /// Both give {"offset": O, "length": L}.
  Json Add(std::string_view bytes);
  template <class T>
  Json AddNumbers(const std::vector<T>& numbers) {
    return Add({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)});
  }
  /// Values rounded to multiples of the quantum, small where neighbours are near. NaN is a missing
  /// value, and so is one beyond 2^31 quanta.
  Json AddChannel(const std::vector<double>& values, double quantum);

  std::size_t size() const { return blobs_.size(); }
  /// Takes back all that was added since the data had that size.
  void CutTo(std::size_t size) { blobs_.resize(size); }
  /// Base64 of gzip of header and blobs. The header must hold no NaN.
  std::string Text(const Json& header) const;

 private:
  std::string blobs_;
};

/// The page with these data in it.
std::string PageWith(const std::string& payload_text);

/// Base64 (RFC 4648) with padding, in one line.
std::string Base64(std::string_view bytes);

}  // namespace dockyard
