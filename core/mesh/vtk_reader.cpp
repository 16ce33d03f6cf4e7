#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <exception>
#include <string>

#include "base/files.hpp"
#include "mesh/file_formats.hpp"
#include "mesh/polygon.hpp"
#include "mesh/vtk_session.hpp"

namespace myo {
namespace {

Error broken(const std::filesystem::path& path) { return {"the file is truncated or garbled", path.string()}; }

// VTK's readers crash or return something on wrong files; what can be seen beforehand is refused here.
Result<std::string> content_beginning_with(const std::filesystem::path& path, std::string_view mark) {
    auto content = read_file(path);
    if (!content) return content.error();
    if (content->empty()) return Error{"the file is empty", path.string()};
    if (content->substr(0, 400).find(mark) == std::string::npos) {
        return Error{"does not begin as a file of this kind: '" + std::string(mark) + "' is missing", path.string()};
    }
    return content;
}

// Runs a reader; false when it complained or threw.
template <class Reader>
bool update(Reader& reader, const std::filesystem::path& path) {
    const VtkSession session;
    try {
        reader.SetFileName(path.c_str());
        reader.Update();
    } catch (const std::exception&) {
        return false;
    }
    return reader.GetErrorCode() == 0 && !session.complained();
}

Result<PolygonSoup> polygons_of(vtkPolyData* data, const std::filesystem::path& path) {
    PolygonSoup soup;
    if (data == nullptr || data->GetPoints() == nullptr) return soup;
    vtkPoints* points = data->GetPoints();
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) {
        double x[3];
        points->GetPoint(i, x);
        soup.vertices.emplace_back(x[0], x[1], x[2]);
    }
    const auto corners_of = [&](vtkCellArray* cells, vtkIdType cell, std::vector<int>& corners) {
        vtkIdType n = 0;
        const vtkIdType* ids = nullptr;
        cells->GetCellAtId(cell, n, ids);
        corners.clear();
        for (vtkIdType i = 0; i < n; ++i) {
            if (ids[i] < 0 || ids[i] >= points->GetNumberOfPoints()) return false;
            corners.push_back(static_cast<int>(ids[i]));
        }
        return true;
    };
    const Error missing{"a polygon names a vertex that does not exist", path.string()};
    std::vector<int> corners;
    if (vtkCellArray* polygons = data->GetPolys(); polygons != nullptr) {
        if (!polygons->IsValid()) return broken(path);
        for (vtkIdType c = 0; c < polygons->GetNumberOfCells(); ++c) {
            if (!corners_of(polygons, c, corners)) return missing;
            for (const auto& triangle : triangles_of(corners, soup.vertices)) soup.triangles.push_back(triangle);
        }
    }
    if (vtkCellArray* strips = data->GetStrips(); strips != nullptr) {
        if (!strips->IsValid()) return broken(path);
        for (vtkIdType c = 0; c < strips->GetNumberOfCells(); ++c) {
            if (!corners_of(strips, c, corners)) return missing;
            for (std::size_t i = 2; i < corners.size(); ++i) {
                // Every second triangle of a strip turns the other way.
                const std::size_t odd = i % 2;
                soup.triangles.push_back({corners[i - 2], corners[i - 1 + odd], corners[i - odd]});
            }
        }
    }
    return soup;
}

enum class Keep { no, yes, unsupported };

Keep keep(int vtk_type, CellType& type) {
    switch (vtk_type) {
        case VTK_HEXAHEDRON:
        case VTK_VOXEL: type = CellType::hex8; return Keep::yes;
        case VTK_TETRA: type = CellType::tet4; return Keep::yes;
        case VTK_QUADRATIC_TETRA: type = CellType::tet10; return Keep::yes;
        case VTK_EMPTY_CELL:
        case VTK_VERTEX:
        case VTK_POLY_VERTEX:
        case VTK_LINE:
        case VTK_POLY_LINE:
        case VTK_TRIANGLE:
        case VTK_TRIANGLE_STRIP:
        case VTK_POLYGON:
        case VTK_PIXEL:
        case VTK_QUAD:
        case VTK_QUADRATIC_EDGE:
        case VTK_QUADRATIC_TRIANGLE:
        case VTK_QUADRATIC_QUAD:
        case VTK_BIQUADRATIC_QUAD:
        case VTK_QUADRATIC_POLYGON: return Keep::no;
        default: return Keep::unsupported;
    }
}

Result<CellSoup> cells_of(vtkUnstructuredGrid* grid, const std::filesystem::path& path) {
    CellSoup soup;
    if (grid == nullptr || grid->GetPoints() == nullptr || grid->GetCells() == nullptr) return soup;
    vtkPoints* points = grid->GetPoints();
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) {
        double x[3];
        points->GetPoint(i, x);
        soup.nodes.emplace_back(x[0], x[1], x[2]);
    }
    vtkCellArray* cells = grid->GetCells();
    vtkUnsignedCharArray* types = grid->GetCellTypesArray();
    if (!cells->IsValid() || types == nullptr || types->GetNumberOfTuples() != cells->GetNumberOfCells()) return broken(path);
    for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c) {
        const int vtk_type = types->GetValue(c);
        CellType type{};
        const Keep kept = keep(vtk_type, type);
        if (kept == Keep::no) continue;
        if (kept == Keep::unsupported) {
            return Error{"cell " + std::to_string(c).append(" (counted from 0) is of VTK type ") + std::to_string(vtk_type)
                             .append(", which is not read: only hex8, tet4 and tet10"), path.string()};
        }
        if (!soup.accepts(type)) {
            return Error{"the mesh mixes " + to_string(soup.type).append(" and ") + to_string(type).append(" cells; one type is needed"), path.string()};
        }
        soup.type = type;
        vtkIdType n = 0;
        const vtkIdType* ids = nullptr;
        cells->GetCellAtId(c, n, ids);
        if (n != nodes_per_cell(type)) return broken(path);
        const std::size_t first = soup.cells.size();
        for (vtkIdType i = 0; i < n; ++i) {
            if (ids[i] < 0 || ids[i] >= points->GetNumberOfPoints()) {
                return Error{"cell " + std::to_string(c).append(" (counted from 0) names a node that does not exist"), path.string()};
            }
            soup.cells.push_back(static_cast<int>(ids[i]));
        }
        if (vtk_type == VTK_VOXEL) {  // counts x first, then y: corners 2 and 3, 6 and 7 change places
            std::swap(soup.cells[first + 2], soup.cells[first + 3]);
            std::swap(soup.cells[first + 6], soup.cells[first + 7]);
        }
    }
    return soup;
}

}  // namespace

Result<PolygonSoup> read_vtp(const std::filesystem::path& path) {
    if (const auto content = content_beginning_with(path, "VTKFile"); !content) return content.error();
    vtkNew<vtkXMLPolyDataReader> reader;
    if (!update(*reader, path)) return broken(path);
    return polygons_of(reader->GetOutput(), path);
}

Result<CellSoup> read_vtu(const std::filesystem::path& path) {
    if (const auto content = content_beginning_with(path, "VTKFile"); !content) return content.error();
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    if (!update(*reader, path)) return broken(path);
    return cells_of(reader->GetOutput(), path);
}

Result<CellSoup> read_legacy_vtk(const std::filesystem::path& path) {
    const auto content = content_beginning_with(path, "# vtk DataFile");
    if (!content) return content.error();
    if (content->find("UNSTRUCTURED_GRID") == std::string::npos) return Error{"is not a VTK unstructured grid", path.string()};
    vtkNew<vtkUnstructuredGridReader> reader;
    if (!update(*reader, path)) return broken(path);
    return cells_of(reader->GetOutput(), path);
}

}  // namespace myo
