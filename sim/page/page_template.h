// The page of a report without its data: the file web/page.html as text.
#pragma once

#include <string_view>

namespace dockyard {

extern const std::string_view kPageTemplate;

}  // namespace dockyard
