// myoloop-tetgen REQUEST ANSWER SWITCHES MEMORY_BYTES CPU_SECONDS
//
// Runs TetGen once, in a process that may abort, be killed or run out of memory without harm to the caller.

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <tetgen.h>

#include <csignal>
#include <cstdlib>
#include <new>
#include <string>

#include "mesh/tetgen_exchange.hpp"

namespace {

/// Sets a resource limit of this process, in the unit of setrlimit(); 0: none.
void limit(__rlimit_resource_t resource, unsigned long long value) {
    if (value == 0) return;
    const rlimit bound{static_cast<rlim_t>(value), static_cast<rlim_t>(value)};
    setrlimit(resource, &bound);
}

/// Fills the input of TetGen: points [3 x n], triangles of the surface as facets, a point in each hole. TetGen frees
/// these arrays itself, hence new[].
void describe(const myo::mesh::TetgenExchange& request, tetgenio& input) {
    // Vertices are numbered from 0, as in the request.
    input.firstnumber = 0;
    input.numberofpoints = static_cast<int>(request.points.size() / 3);
    input.pointlist = new REAL[request.points.size()];
    std::copy(request.points.begin(), request.points.end(), input.pointlist);

    input.numberoffacets = static_cast<int>(request.cells.size() / 3);
    input.facetlist = new tetgenio::facet[static_cast<std::size_t>(input.numberoffacets)];
    for (int f = 0; f < input.numberoffacets; ++f) {
        tetgenio::facet& facet = input.facetlist[f];
        tetgenio::init(&facet);
        // A facet is one triangle without holes of its own.
        facet.numberofpolygons = 1;
        facet.polygonlist = new tetgenio::polygon[1];
        tetgenio::init(&facet.polygonlist[0]);
        facet.polygonlist[0].numberofvertices = 3;
        facet.polygonlist[0].vertexlist = new int[3];
        for (int i = 0; i < 3; ++i) {
            facet.polygonlist[0].vertexlist[i] = request.cells[static_cast<std::size_t>(3 * f + i)];
        }
    }
    if (request.holes.empty()) return;
    input.numberofholes = static_cast<int>(request.holes.size() / 3);
    input.holelist = new REAL[request.holes.size()];
    std::copy(request.holes.begin(), request.holes.end(), input.holelist);
}

/// Reads the request, runs TetGen and writes the answer; returns the exit status, see mesh::worker_status.
///
/// @param switches  of TetGen; by value, as it takes a modifiable text
int run(const std::string& request_path, const std::string& answer_path, std::string switches) {
    myo::mesh::TetgenExchange request, answer;
    if (!myo::mesh::read_exchange(request_path, request) || request.points.empty() || request.cells.empty()) {
        return myo::mesh::worker_status::bad_call;
    }
    // TetGen works on the arrays of these objects and frees them with the objects.
    tetgenio input, output;
    describe(request, input);
    try {
        tetrahedralize(switches.data(), &input, &output);
    } catch (int code) {
        // TetGen throws its error code; 1 is a lack of memory.
        if (code == 1) return myo::mesh::worker_status::out_of_memory;
        return myo::mesh::worker_status::tetgen_error + code;
    }
    if (output.numberofpoints > 0) answer.points.assign(output.pointlist, output.pointlist + 3 * output.numberofpoints);
    if (output.numberoftetrahedra > 0) {
        answer.cells.assign(output.tetrahedronlist, output.tetrahedronlist + 4 * output.numberoftetrahedra);
    }
    return myo::mesh::write_exchange(answer_path, answer) ? myo::mesh::worker_status::done
                                                          : myo::mesh::worker_status::cannot_write;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 6) return myo::mesh::worker_status::bad_call;
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // ends with the caller
#if !defined(MYOLOOP_SANITIZED)        // the sanitizer reserves terabytes of address space
    limit(RLIMIT_AS, std::strtoull(argv[4], nullptr, 10));
#endif
    limit(RLIMIT_CPU, std::strtoull(argv[5], nullptr, 10));
    // A crash of TetGen is expected for some surfaces and must not leave core files.
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    try {
        return run(argv[1], argv[2], argv[3]);
    } catch (const std::bad_alloc&) {
        return myo::mesh::worker_status::out_of_memory;
    }
}
