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

/** What the eye sees of light that a path brings to the surface that it is at. A mutable work object, one per thread. */
final class EyeConnection {
    private final PathFollower path;
    private final EyeProjection eye;
    private final boolean absorbs;

    /** Follows rays to the eye through glass that does not turn them; null if there is none. */
    private final ShadowWalk walk;

    private final Ray ray = new Ray();

    /** What comes through on the way to the eye, by band. */
    final double[] through = new double[3];

    EyeConnection(CompiledScene scene, RayCounters counters, PathFollower path) {
        this.path = path;
        eye = EyeProjection.of(scene.camera);
        absorbs = scene.physical.hasAbsorption;
        walk = scene.physical.hasStraightGlass ? new ShadowWalk(scene, counters) : null;
    }

    /** What samples the points of segments that are connected to the eye: where it is near, more of them. */
    Equiangular sampling() {
        return new Equiangular(eye.isParallel() ? Vec3.ZERO : eye.start());
    }

    /** The place in the picture, 0..1 from the left. */
    double x() {
        return eye.x;
    }

    /** From above, 0..1. */
    double y() {
        return eye.y;
    }

    /** The share of the picture per unit of what scatters light there ({@link EyeProjection#importance}). */
    double importance() {
        return eye.importance;
    }

    /** Whether {@link #sampleStart} must choose where each connection ends: on a lens, or at one of two eyes. */
    boolean hasSeveralStarts() {
        return eye.hasSeveralStarts();
    }

    /** Chooses where connections end, by two random numbers in 0..1. */
    void sampleStart(double u, double v) {
        eye.sampleStart(u, v);
    }

    /** Finds the place where the surface's point is seen, if nothing hides it; returns whether it is in the picture. */
    boolean project() {
        return eye.project(path.at.hit.px, path.at.hit.py, path.at.hit.pz);
    }

    /**
     * Whether light goes from there to the eye, and how much of it is left there ({@link #through}).
     *
     * @param s the surface, which light comes to from o; receives the direction to the eye and what the surface's Bsdf says of it
     * @param tint of what passes a rough border; null if the surface is none
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

    private boolean isHidden(boolean isBorder, boolean isBeyond) {
        path.poll.tick();
        double length = Math.sqrt(eye.toEyeX * eye.toEyeX + eye.toEyeY * eye.toEyeY + eye.toEyeZ * eye.toEyeZ);
        if (length <= eye.error) {
            // It is where camera rays start: they meet it first.
            return false;
        }
        if (!start(isBorder, isBeyond) && !path.tracer.occluded(ray, 1 + eye.error / length)) {
            SurfaceMaterial medium = absorbs ? path.medium(isBeyond) : null;
            if (medium != null && medium.absorbs) {
                medium.absorb(length, through);
            }
            return false;
        }
        if (walk == null) {
            return true;
        }
        start(isBorder, isBeyond);
        return !walk.reachesEye(ray, length, eye.error, path, isBeyond, through);
    }

    /** Returns whether something is in the ray's way at once. */
    private boolean start(boolean isBorder, boolean isBeyond) {
        ray.set(path.at.hit.px, path.at.hit.py, path.at.hit.pz, eye.toEyeX, eye.toEyeY, eye.toEyeZ, 0);
        return Departure.from(path, ray, isBorder, isBeyond);
    }
}
