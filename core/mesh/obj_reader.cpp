#include "base/files.hpp"
#include "mesh/file_formats.hpp"
#include "mesh/polygon.hpp"
#include "mesh/text_scanner.hpp"

namespace myo::mesh {

// Positions (v) and faces (f). Texture, normals, groups and materials are not needed for a mesh.
Result<PolygonSoup> read_obj(const std::filesystem::path& path) {
    const auto content = read_file(path);
    if (!content) return content.error();
    if (content->empty()) return Error{"the file is empty", path.string()};
    if (content->find('\0') != std::string::npos) return Error{"is not an OBJ text file", path.string()};

    PolygonSoup soup;
    TextScanner text(*content, path.string());
    do {
        const std::string_view word = text.word_on_line();
        if (word == "v") {
            Eigen::Vector3d x;
            for (Eigen::Index a = 0; a < 3; ++a) {
                if (!text.number_on_line(x[a])) return text.error("a vertex needs three finite numbers");
            }
            soup.vertices.push_back(x);
        } else if (word == "f") {
            std::vector<int> polygon;
            for (std::string_view corner = text.word_on_line(); !corner.empty(); corner = text.word_on_line()) {
                long long index = 0;
                if (!TextScanner::parse(corner.substr(0, corner.find('/')), index))
                    return text.error("a face needs vertex numbers");
                const auto count = static_cast<long long>(soup.vertices.size());
                // Indices count from 1, or backwards from the last vertex so far.
                if (index < 0) index += count + 1;
                if (index < 1 || index > count) return text.error("a face names a vertex that does not exist");
                polygon.push_back(static_cast<int>(index - 1));
            }
            if (polygon.size() < 3) return text.error("a face needs at least three vertices");
            for (const auto& triangle : triangles_of(polygon, soup.vertices)) soup.triangles.push_back(triangle);
        }
    } while (text.next_line());
    return soup;
}

}  // namespace myo::mesh
