package enlightenment.transport.direct;

import enlightenment.transport.ray.PathFollower;

/**
 * The last vertex with next-event estimation, in the frame, and its normal on the side that the path came from: 0 where light is taken from
 * all sides. Mutable, one per thread.
 */
final class LitVertex {
    double x;
    double y;
    double z;
    double nx;
    double ny;
    double nz;

    /** Sets it to the path's current vertex. */
    void set(PathFollower path) {
        x = path.at.hit.px;
        y = path.at.hit.py;
        z = path.at.hit.pz;
        nx = path.at.nx;
        ny = path.at.ny;
        nz = path.at.nz;
    }

    /** Makes it take light from all sides. */
    void openToAllSides() {
        nx = 0;
        ny = 0;
        nz = 0;
    }
}
