// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Answers to requests that are not for a socket.

#include <cstdint>
#include <string_view>

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/status.hpp>
#include <boost/beast/http/string_body.hpp>

namespace balcony::studio {

using Response = boost::beast::http::response<boost::beast::http::string_body>;

/// A file of the page by its path: "/", "/studio.js". Of a server at a port.
[[nodiscard]] Response file_response(std::string_view path, std::uint16_t port);
/// A line of text that says what is wrong.
[[nodiscard]] Response refusal_response(boost::beast::http::status status, std::string_view reason,
                                        std::uint16_t port);

}  // namespace balcony::studio
