#pragma once
/// The secret of a studio's sessions on disk, so that pages which were open when a studio was killed find back to the next one
/// on the same port. A studio that ends in an orderly way takes it along.

#include <filesystem>
#include <string>

namespace lissom {

/// Where such secrets are kept: a folder that only this user can read (in XDG_RUNTIME_DIR, or in the state folder of the user).
/// Empty when there is none.
std::filesystem::path session_folder();

/// Where the studio may remember other things about this user, such as recent files. Empty when there is no such place.
std::filesystem::path state_folder();

/// The secret for a port: what the last studio there left behind, if the file is this user's alone and well formed, else a
/// new one, which is written. Where nothing can be written the secret is new each time.
std::string kept_session(const std::filesystem::path& folder, unsigned short port);

/// Ends all sessions of a port.
void forget_session(const std::filesystem::path& folder, unsigned short port);

}  // namespace lissom
