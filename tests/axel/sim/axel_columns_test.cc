// Axel's columns, which docs/reference/columns.md lists.
#include "sim/axel/axel_columns.h"

#include <gtest/gtest.h>

#include <cctype>
#include <string>

namespace dockyard {
namespace {

TEST(AxelColumns, EachHasAMeaningAndANameThatEndsInItsUnit) {
  for (const auto& columns :
       {ChannelsOf<axel::Truth>(), axel::Beliefs(), MeasuresOf<axel::AxelMeasures>()}) {
    for (const Column& column : columns) {
      EXPECT_FALSE(column.meaning.empty()) << column.name;
      std::string ending = column.unit.empty() ? "" : "_" + column.unit;
      for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      EXPECT_TRUE(column.name.ends_with(ending)) << column.name << " [" << column.unit << "]";
    }
  }
}

}  // namespace
}  // namespace dockyard
