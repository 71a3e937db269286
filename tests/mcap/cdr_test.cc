#include "sim/mcap/cdr.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace dockyard {
namespace {

std::string Bytes(std::initializer_list<int> numbers) {
  std::string bytes;
  for (const int number : numbers) bytes += static_cast<char>(number);
  return bytes;
}

// Written out by hand from the rules of XCDR1: 9.3.1 of the CORBA specification, 10.2 of DDSI-RTPS.
TEST(Cdr, PutsEachNumberAtAMultipleOfItsSize) {
  CdrWriter writer;
  writer.U8(1);
  writer.U32(2);
  writer.Text("ab");
  writer.U16(3);
  writer.Double(1.0);
  EXPECT_EQ(writer.Take(), Bytes({0, 1, 0, 0,                     // little-endian CDR
                                  1, 0, 0, 0, 2,   0,   0,    0,  // three of gap
                                  3, 0, 0, 0, 'a', 'b', 0,        // a text with its zero
                                  0, 3, 0,                        // one of gap
                                  0, 0, 0, 0, 0,   0,             // six of gap
                                  0, 0, 0, 0, 0,   0,   0xf0, 0x3f}));
}

TEST(Cdr, GivesBackWhatWasWritten) {
  CdrWriter writer;
  writer.Bool(true);
  writer.I32(-7);
  writer.U16(65535);
  writer.U64(std::uint64_t{1} << 63);
  writer.Float(-0.5f);
  writer.Text("");
  writer.Bytes(Bytes({0, 255, 7}));
  writer.Doubles({1e-300, -0.0});
  const std::string message = writer.Take();
  CdrReader reader(message);
  EXPECT_TRUE(reader.Bool());
  EXPECT_EQ(reader.I32(), -7);
  EXPECT_EQ(reader.U16(), 65535);
  EXPECT_EQ(reader.U64(), std::uint64_t{1} << 63);
  EXPECT_EQ(reader.Float(), -0.5f);
  EXPECT_EQ(reader.Text(), "");
  EXPECT_EQ(reader.Bytes(), Bytes({0, 255, 7}));
  EXPECT_EQ(reader.Doubles(), (std::vector<double>{1e-300, -0.0}));
  EXPECT_TRUE(reader.AtEnd());
}

TEST(Cdr, RefusesMessagesThatEndEarlyOrAreInAnotherEncoding) {
  CdrWriter writer;
  writer.Text("abc");
  writer.Doubles({1.0, 2.0});
  const std::string message = writer.Take();
  for (std::size_t size = 0; size < message.size(); ++size) {
    EXPECT_THROW(
        {
          CdrReader reader(std::string_view(message).substr(0, size));
          reader.Text();
          reader.Doubles();
        },
        DataError)
        << size;
  }
  std::string big_endian = message;
  big_endian[1] = 0;
  EXPECT_THROW(CdrReader{big_endian}, DataError);
  CdrWriter long_list;
  long_list.Count(1u << 30);
  const std::string lies = long_list.Take();
  EXPECT_THROW(CdrReader(lies).Doubles(), DataError);
}

}  // namespace
}  // namespace dockyard
