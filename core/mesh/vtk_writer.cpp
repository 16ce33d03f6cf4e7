#include "mesh/vtk_writer.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cassert>
#include <cstdint>
#include <exception>

#include <Eigen/Geometry>

#include "base/files.hpp"
#include "base/text.hpp"
#include "mesh/cell_traits.hpp"
#include "mesh/vtk_session.hpp"

namespace myo::mesh {
namespace {

/// Adds fields as VTK arrays. VTK stores all components of a tuple together, like a column of the field.
void add_fields(vtkDataSetAttributes* attributes, const std::vector<MeshField>& fields,
                [[maybe_unused]] Eigen::Index count) {
    for (const MeshField& field : fields) {
        assert(field.values.cols() == count);
        vtkNew<vtkDoubleArray> array;
        array->SetName(field.name.c_str());
        array->SetNumberOfComponents(static_cast<int>(field.values.rows()));
        array->SetNumberOfTuples(field.values.cols());
        std::copy(field.values.data(), field.values.data() + field.values.size(), array->GetPointer(0));
        attributes->AddArray(array);
    }
}

}  // namespace

Result<void> write_vtu(const std::filesystem::path& path, const VolumeMesh& mesh,
                       const std::vector<MeshField>& point_fields, const std::vector<MeshField>& cell_fields) {
    // Double precision, so that a mesh can be written and read back without loss.
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(mesh.node_count());
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i) points->SetPoint(i, mesh.nodes.col(i).data());
    // Nodes are in VTK's order already.
    vtkNew<vtkCellArray> cells;
    std::vector<vtkIdType> ids(static_cast<std::size_t>(mesh.cells.rows()));
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = mesh.cells(static_cast<Eigen::Index>(i), c);
        cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(points);
    grid->SetCells(cell_traits(mesh.type).vtk_type, cells);
    add_fields(grid->GetPointData(), point_fields, mesh.node_count());
    add_fields(grid->GetCellData(), cell_fields, mesh.cell_count());

    std::string content;
    try {
        // VTK reports errors by messages instead of return values.
        const VtkSession session;
        vtkNew<vtkXMLUnstructuredGridWriter> writer;
        writer->WriteToOutputStringOn();
        writer->SetInputData(grid);
        writer->SetDataModeToAppended();
        // Raw appended data: no base64 overhead.
        writer->EncodeAppendedDataOff();
        const bool made = writer->Write() == 1 && writer->GetErrorCode() == 0 && !session.complained();
        if (!made) return Error{"VTK cannot write this mesh", path.string()};
        content = writer->GetOutputString();
    } catch (const std::exception&) {
        return Error{"VTK cannot write this mesh", path.string()};
    }
    return write_file(path, content);
}

Result<void> write_stl(const std::filesystem::path& path, const SurfaceMesh& surface, double metres_per_unit) {
    // 80-byte header, number of triangles, then normal, corners and a 16-bit attribute per triangle.
    std::string content(80, ' ');
    const auto append = [&](const auto& value) { content.append(reinterpret_cast<const char*>(&value), sizeof value); };
    append(static_cast<std::uint32_t>(surface.triangles.cols()));
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
        Eigen::Matrix3d x;
        for (Eigen::Index i = 0; i < 3; ++i) x.col(i) = surface.vertices.col(surface.triangles(i, t)) / metres_per_unit;
        const Eigen::Vector3d normal = (x.col(1) - x.col(0)).cross(x.col(2) - x.col(0)).normalized();
        for (const double value : normal) append(static_cast<float>(value));
        for (const double value : x.reshaped()) append(static_cast<float>(value));
        append(std::uint16_t{0});
    }
    return write_file(path, content);
}

Result<void> write_pvd(const std::filesystem::path& path, const std::vector<double>& times,
                       const std::vector<std::filesystem::path>& files) {
    assert(times.size() == files.size());
    std::string xml =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  "
        "<Collection>\n";
    for (std::size_t i = 0; i < files.size(); ++i) {
        std::string name;
        // File names may contain characters that are special in XML.
        for (const char c : files[i].generic_string()) {
            switch (c) {
                case '&': name += "&amp;"; break;
                case '<': name += "&lt;"; break;
                case '"': name += "&quot;"; break;
                default: name += c;
            }
        }
        xml.append("    <DataSet timestep=\"")
            .append(format_number(times[i], 12))
            .append("\" part=\"0\" file=\"")
            .append(name)
            .append("\"/>\n");
    }
    xml += "  </Collection>\n</VTKFile>\n";
    return write_file(path, xml);
}

}  // namespace myo::mesh
