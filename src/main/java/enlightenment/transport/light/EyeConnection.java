package enlightenment.transport.light;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.transport.media.Equiangular;
import enlightenment.transport.ray.Departure;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.ray.ShadowWalk;
import enlightenment.world.CompiledScene;
import enlightenment.world.camera.EyeProjection;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;

/**
 * Connects the current vertex of a light path to the eye: film position, visibility and importance. A mutable work object, one per thread.
 */
final class EyeConnection {
    private final PathFollower path;
    private final EyeProjection eye;
    private final boolean absorbs;

    /** Follows rays to the eye through glass that keeps their direction; null if the scene has none. */
    private final ShadowWalk walk;

    private final Ray ray = new Ray();

    /** The transmittance of the connection, by band. */
    final double[] through = new double[3];

    EyeConnection(CompiledScene scene, RayCounters counters, PathFollower path) {
        this.path = path;
        eye = EyeProjection.of(scene.camera);
        absorbs = scene.physical.hasAbsorption;
        walk = scene.physical.hasStraightGlass ? new ShadowWalk(scene, counters) : null;
    }

    /** Equiangular sampling of points of flights to connect to the eye: denser where the eye is near. */
    Equiangular sampling() {
        return new Equiangular(eye.isParallel() ? Vec3.ZERO : eye.start());
    }

    /** The film position, 0..1 from the left. */
    double x() {
        return eye.x;
    }

    /** The film position, 0..1 from above. */
    double y() {
        return eye.y;
    }

    /** The camera's importance of the vertex ({@link EyeProjection#importance}). */
    double importance() {
        return eye.importance;
    }

    /** Whether the camera has a lens or two eyes, so that {@link #sampleStart} must choose the end of each connection. */
    boolean hasSeveralStarts() {
        return eye.hasSeveralStarts();
    }

    /** Samples the end of the connection on the camera, by two random numbers in 0..1. */
    void sampleStart(double u, double v) {
        eye.sampleStart(u, v);
    }

    /** Projects the vertex onto the film; returns whether it is in the picture, visibility aside. */
    boolean project() {
        return eye.project(path.at.hit.px, path.at.hit.py, path.at.hit.pz);
    }

    /**
     * Whether the vertex scatters light towards the eye and nothing occludes it; sets {@link #through}.
     *
     * @param s the scattering at the vertex, with o set; receives the direction to the eye and the BSDF's value
     * @param tint of transmitted light at a rough interface; null elsewhere
     */
    boolean sees(Bsdf bsdf, Scattering s, double[] tint) {
        s.ix = eye.dx;
        s.iy = eye.dy;
        s.iz = eye.dz;
        bsdf.evaluate(s);
        if (!(s.valueR > 0 || s.valueG > 0 || s.valueB > 0)) {
            return false;
        }
        boolean isBeyond = tint != null && s.ix * s.nx + s.iy * s.ny + s.iz * s.nz < 0;
        Arrays.fill(through, 1);
        if (isHidden(tint != null, isBeyond)) {
            return false;
        }
        for (int c = 0; isBeyond && c < through.length; c++) {
            through[c] *= tint[c];
        }
        return true;
    }

    private boolean isHidden(boolean isInterface, boolean isBeyond) {
        path.poll.tick();
        double length = Math.sqrt(eye.toEyeX * eye.toEyeX + eye.toEyeY * eye.toEyeY + eye.toEyeZ * eye.toEyeZ);
        if (length <= eye.error) {
            // The vertex is where camera rays start: nothing can be in between.
            return false;
        }
        if (!start(isInterface, isBeyond) && !path.tracer.occluded(ray, 1 + eye.error / length)) {
            SurfaceMaterial medium = absorbs ? path.medium(isBeyond) : null;
            if (medium != null && medium.absorbs) {
                medium.absorb(length, through);
            }
            return false;
        }
        if (walk == null) {
            return true;
        }
        start(isInterface, isBeyond);
        return !walk.reachesEye(ray, length, eye.error, path, isBeyond, through);
    }

    /** Starts the ray; returns whether a surface that coincides with the vertex occludes it. */
    private boolean start(boolean isInterface, boolean isBeyond) {
        ray.set(path.at.hit.px, path.at.hit.py, path.at.hit.pz, eye.toEyeX, eye.toEyeY, eye.toEyeZ, 0);
        return Departure.from(path, ray, isInterface, isBeyond);
    }
}
