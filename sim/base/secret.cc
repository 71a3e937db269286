#include "sim/base/secret.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <sys/random.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

#include "controller/base/check.h"
#include "sim/base/files.h"

namespace dockyard {
namespace {

std::string Hexadecimal(const std::uint8_t* bytes, std::size_t count) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += kDigits[bytes[i] >> 4];
    text += kDigits[bytes[i] & 15];
  }
  return text;
}

int DigitOf(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

Secret NewSecret() {
  Secret secret;
  const auto size = static_cast<ssize_t>(secret.bytes.size());
  if (::getrandom(secret.bytes.data(), secret.bytes.size(), 0) != size) {
    throw IoErrorFromErrno("get random bits from", "the system");
  }
  return secret;
}

std::string SecretText(const Secret& secret) {
  return Hexadecimal(secret.bytes.data(), secret.bytes.size());
}

Secret ReadSecret(const std::filesystem::path& file) {
  const auto content = ReadWhole(file);
  if (!content) throw IoError("cannot read " + file.string() + ": no such file");
  const auto bad = [&] {
    return std::invalid_argument(file.string() + ": expected 32 hexadecimal digits");
  };
  Secret secret;
  std::size_t digits = 0;
  for (const char c : *content) {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    const int digit = DigitOf(c);
    if (digit < 0 || digits == 2 * secret.bytes.size()) throw bad();
    std::uint8_t& byte = secret.bytes[digits++ / 2];
    byte = static_cast<std::uint8_t>(byte << 4 | digit);
  }
  if (digits != 2 * secret.bytes.size()) throw bad();
  return secret;
}

Secret ReadOrMakeSecret(const std::filesystem::path& file) {
  if (std::filesystem::exists(file)) return ReadSecret(file);
  // Written whole under a name of its own; a link, unlike a rename, leaves a file that is there.
  const Secret secret = NewSecret();
  const std::string own = file.string() + "." + SecretText(NewSecret()).substr(0, 8) + ".tmp";
  const std::string text = SecretText(secret) + "\n";
  const int descriptor = ::open(own.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) throw IoErrorFromErrno("make", file);
  const bool written =
      ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
      ::fsync(descriptor) == 0;
  const bool linked = written && ::link(own.c_str(), file.c_str()) == 0;
  const bool is_there = written && !linked && errno == EEXIST;
  const IoError error = IoErrorFromErrno("write", file);
  ::close(descriptor);
  ::unlink(own.c_str());
  if (is_there) return ReadSecret(file);
  if (!linked) throw error;
  return secret;
}

std::string Fingerprint(const Secret& secret) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  DOCKYARD_CHECK(EVP_Digest(secret.bytes.data(), secret.bytes.size(), digest.data(), &size,
                            EVP_sha256(), nullptr) == 1);
  return Hexadecimal(digest.data(), size);
}

std::uint64_t SealedBits(const Secret& secret, std::string_view purpose,
                         const std::vector<std::uint64_t>& numbers) {
  std::string message(purpose);
  message += '\0';
  for (const std::uint64_t number : numbers) {
    for (int byte = 0; byte < 8; ++byte) message += static_cast<char>(number >> (8 * byte));
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> code{};
  unsigned size = 0;
  DOCKYARD_CHECK(HMAC(EVP_sha256(), secret.bytes.data(), static_cast<int>(secret.bytes.size()),
                      reinterpret_cast<const unsigned char*>(message.data()), message.size(),
                      code.data(), &size) != nullptr);
  std::uint64_t bits = 0;
  for (int byte = 7; byte >= 0; --byte) bits = bits << 8 | code[static_cast<std::size_t>(byte)];
  return bits;
}

}  // namespace dockyard
