// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/web/page_response.hpp"

#include <string>

#include <fmt/format.h>

#include "studio/page_files.hpp"

namespace balcony::studio {

namespace http = boost::beast::http;

namespace {

constexpr unsigned http_1_1 = 11;

constexpr std::string_view no_page =
    "<!doctype html>\n<meta charset=\"utf-8\">\n<title>Balcony</title>\n"
    "<p>This balcony was built without the page of the studio, which needs npm: "
    "<code>scripts/studio</code> sets it up. Programs can use the protocol of docs/studio.md.\n";

// A browser that has the page may show it in no other one, and run no text but that of its files.
std::string security_policy(std::uint16_t port) {
    return fmt::format(
        "default-src 'self'; connect-src 'self' ws://127.0.0.1:{0} ws://localhost:{0}; "
        "img-src 'self' blob: data:; object-src 'none'; base-uri 'none'; form-action 'none'; "
        "frame-ancestors 'none'",
        port);
}

Response response_of(http::status status, std::string_view type, std::uint16_t port) {
    Response made{status, http_1_1};
    made.set(http::field::content_type, boost::beast::string_view(type.data(), type.size()));
    made.set(http::field::cache_control, "no-store");
    made.set("Content-Security-Policy", security_policy(port));
    made.set("X-Content-Type-Options", "nosniff");
    made.set("X-Frame-Options", "DENY");
    made.set("Referrer-Policy", "no-referrer");
    made.set("Cross-Origin-Resource-Policy", "same-origin");
    made.keep_alive(false);
    return made;
}

}  // namespace

Response file_response(std::string_view path, std::uint16_t port) {
    const std::string_view name = path == "/" ? "index.html" : path.substr(1);
    for (const PageFile& file : page_files()) {
        if (file.path == name) {
            Response made = response_of(http::status::ok, file.type, port);
            if (file.is_gzip) {
                made.set(http::field::content_encoding, "gzip");
            }
            made.body().assign(file.bytes.begin(), file.bytes.end());
            made.prepare_payload();
            return made;
        }
    }
    if (path == "/") {
        Response made = response_of(http::status::ok, "text/html; charset=utf-8", port);
        made.body() = no_page;
        made.prepare_payload();
        return made;
    }
    return refusal_response(http::status::not_found, "there is no such file", port);
}

Response refusal_response(http::status status, std::string_view reason, std::uint16_t port) {
    Response made = response_of(status, "text/plain; charset=utf-8", port);
    made.body() = fmt::format("{}\n", reason);
    if (status == http::status::method_not_allowed) {
        made.set(http::field::allow, "GET");
    }
    made.prepare_payload();
    return made;
}

}  // namespace balcony::studio
