// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/sha256.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <stdexcept>

namespace sinew {
namespace {

void expect(int done) {
  if (done != 1) throw std::runtime_error("SHA-256 failed in libcrypto");
}

}  // namespace

void Sha256::Free::operator()(evp_md_ctx_st* state) const {
  EVP_MD_CTX_free(state);
}

Sha256::Sha256() : state_(EVP_MD_CTX_new()) {
  expect(EVP_DigestInit_ex(state_.get(), EVP_sha256(), nullptr));
}

void Sha256::update(const char* bytes, size_t count) {
  expect(EVP_DigestUpdate(state_.get(), bytes, count));
}

std::string Sha256::finish() {
  std::array<unsigned char, 32> digest;
  expect(EVP_DigestFinal_ex(state_.get(), digest.data(), nullptr));
  std::string text;
  for (const unsigned char byte : digest) text += fmt::format("{:02x}", byte);
  return text;
}

}  // namespace sinew
