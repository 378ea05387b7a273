#include "base/program_fingerprint.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

#include "base/digest.hpp"
#include "base/errors.hpp"

namespace crawford {

namespace {

size_t padded(size_t size) {
    return (size + 3) / 4 * 4;
}

/// The build id among the notes of one segment (ELF, "Note Section"); empty if it has none.
std::string build_id_in(const char* at, size_t size) {
    const char* const end = at + size;
    while (at + sizeof(ElfW(Nhdr)) <= end) {
        const auto& note = *reinterpret_cast<const ElfW(Nhdr)*>(at);
        const char* const name = at + sizeof note;
        const char* const content = name + padded(note.n_namesz);
        if (note.n_type == NT_GNU_BUILD_ID && std::string_view(name) == ELF_NOTE_GNU) {
            std::string id;
            for (size_t k = 0; k < note.n_descsz; ++k)
                id += fmt::format("{:02x}", static_cast<unsigned char>(content[k]));
            return id;
        }
        at = content + padded(note.n_descsz);
    }
    return {};
}

std::string build_id_of(const dl_phdr_info& object) {
    for (int k = 0; k < object.dlpi_phnum; ++k) {
        const auto& segment = object.dlpi_phdr[k];
        if (segment.p_type != PT_NOTE) continue;
        // The loader gives addresses as numbers.
        const auto* const notes =
            reinterpret_cast<const char*>(  // NOLINT(performance-no-int-to-ptr)
                object.dlpi_addr + segment.p_vaddr);
        if (auto id = build_id_in(notes, segment.p_memsz); !id.empty()) return id;
    }
    return {};
}

std::string digest_of_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError("cannot read " + path + ", which this program has loaded");
    return digest(std::string{std::istreambuf_iterator<char>(file), {}});
}

/// Called for each object that is loaded; `ids` is the vector of what they are known by.
int note_object(dl_phdr_info* object, size_t, void* ids) {
    const std::string name = object->dlpi_name;
    if (name.starts_with("linux-vdso")) return 0;  // the kernel's, and no arithmetic
    std::string id = build_id_of(*object);
    if (id.empty()) id = digest_of_file(name.empty() ? "/proc/self/exe" : name);
    static_cast<std::vector<std::string>*>(ids)->push_back(std::move(id));
    return 0;
}

}  // namespace

std::string program_fingerprint() {
    std::vector<std::string> ids;
    dl_iterate_phdr(note_object, &ids);
    std::ranges::sort(ids);  // by contents, not by the order of loading
    std::string all;
    for (const std::string& id : ids) all += id + '\n';
    return digest(all);
}

}  // namespace crawford
