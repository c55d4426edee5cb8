package enlightenment.probe;

import enlightenment.film.SampleLog;
import enlightenment.frame.SceneFrame;
import enlightenment.math.ExactPoint;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import enlightenment.transport.ray.PathFollower;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;

/**
 * Tells of camera samples which ray they are, in the paper's words: P on the window, S on the surface that is seen, L on a light, and what
 * became of it. It follows rays of its own beside those that are shaded, and counts nothing. One per thread.
 */
abstract class RayProbe {
    private static final int S = 3;
    private static final int L = 6;

    final PathFollower path;

    /** P, S and L in the scene's units. */
    final double[] points = new double[SampleLog.COORDINATES];

    /** The camera ray, which the path overwrites. */
    private final Ray ray = new Ray();

    final double[] surface = new double[3];
    private final double[] origin = new double[3];
    private final int exponent;

    SampleLog.Outcome outcome;
    int bounces;

    RayProbe(CompiledScene scene, int maxBounces) {
        path = new PathFollower(scene, new RayCounters(scene.kindNames.size()), maxBounces);
        SceneFrame frame = scene.frame;
        ExactPoint o = frame.origin();
        origin[0] = o.x().doubleValue();
        origin[1] = o.y().doubleValue();
        origin[2] = o.z().doubleValue();
        exponent = frame.exponent();
    }

    final void beginTile(double x0, double y0, double x1, double y1) {
        path.tracer.beginTile(x0, y0, x1, y1);
    }

    /** Notes a camera ray before it is followed. */
    final void begin(Ray camera) {
        Arrays.fill(points, Double.NaN);
        ray.set(camera.ox, camera.oy, camera.oz, camera.dx, camera.dy, camera.dz, camera.tMin);
        // The camera's rays pass the window one direction's length on.
        put(0, camera.ox + camera.dx, camera.oy + camera.dy, camera.oz + camera.dz);
    }

    /** Finds out about the ray that was noted, whose sample has been shaded. */
    abstract void tell(SobolSampler sampler);

    /** Follows the ray that was noted to the first surface that is no mirror; returns whether it may ask for light there. */
    final boolean follow(SobolSampler sampler) {
        path.begin(ray, sampler);
        outcome = SampleLog.Outcome.UNLIT;
        do {
            PathFollower.Event event = path.next(ray);
            bounces = path.surfaces;
            if (event == PathFollower.Event.NOTHING) {
                outcome = SampleLog.Outcome.MISSED;
                return false;
            }
            if (event == PathFollower.Event.LIGHT) {
                outcome = SampleLog.Outcome.LIGHT_SEEN;
                double t = path.light.surface.nearest(ray, Double.MAX_VALUE);
                if (t != Primitive.MISS) {
                    put(S, Math.fma(t, ray.dx, ray.ox), Math.fma(t, ray.dy, ray.oy), Math.fma(t, ray.dz, ray.oz));
                }
                return false;
            }
            if (event == PathFollower.Event.SURFACE && !path.at.material.isDelta) {
                put(S, path.at.hit.px, path.at.hit.py, path.at.hit.pz);
                return true;
            }
            if (event == PathFollower.Event.SURFACE) {
                Arrays.fill(surface, 1);
                path.scatter(ray, path.at.material, surface, 0, 0, 0);
            } else if (!cross(ray, sampler)) {
                return true;
            }
        } while (path.continues());
        return false;
    }

    /** Goes on at glass; false where the path is at a surface to be lit, which {@link #surfaceIsAt} has told. */
    abstract boolean cross(Ray at, SobolSampler sampler);

    final void surfaceIsAt(double x, double y, double z) {
        put(S, x, y, z);
    }

    final void lightIsAt(double x, double y, double z) {
        put(L, x, y, z);
    }

    private void put(int first, double x, double y, double z) {
        points[first] = origin[0] + Scale.scalb(x, exponent);
        points[first + 1] = origin[1] + Scale.scalb(y, exponent);
        points[first + 2] = origin[2] + Scale.scalb(z, exponent);
    }
}
