package enlightenment.toy;

import enlightenment.film.SplatBatch;
import enlightenment.math.Vec3;
import enlightenment.method.SplatIntegrator;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.sampling.Hash;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import enlightenment.world.Tracer;
import enlightenment.world.parts.RayCounters;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/**
 * Chooses points uniformly by area on all balls of the scene, each of which has the same radiance everywhere, and connects them to the
 * eye. With g(x, y) = g₀ + x·gₓ + y·g_y the camera's ray through (x, y), 0..1 over the picture, a solid angle dω around it covers
 * the area |g|³/|det(g₀, gₓ, g_y)| dω of the picture; so a point at distance d whose normal has the cosine c with the ray is worth
 * A · c/d² · |g|³/|det| times that radiance, where A is the area of all balls.
 */
final class EyeVisibilityIntegrator implements SplatIntegrator {
    private static final long BALL = 1;
    private static final long HEIGHT = 2;
    private static final long TURN = 3;

    private final double radiance;
    private final long seed;
    private final int width;
    private final int height;
    private final RayCounters counters;
    private final Tracer tracer;
    private final List<SpherePrimitive> balls = new ArrayList<>();
    private final double[] areas;
    private final double allAreas;
    private final Vec3 eye;
    private final Vec3 g0;
    private final Vec3 gx;
    private final Vec3 gy;
    private final double det;
    private final Ray ray = new Ray();
    private final Hit hit = new Hit();
    private BooleanSupplier cancelled = () -> false;

    EyeVisibilityIntegrator(CompiledScene scene, RenderSettings settings, RayCounters counters, double radiance) {
        this.radiance = radiance;
        seed = settings.seed();
        width = settings.width();
        height = settings.height();
        this.counters = counters;
        tracer = new Tracer(scene, counters);
        for (Primitive p : scene.primitives) {
            if (p instanceof SpherePrimitive ball) {
                balls.add(ball);
            }
        }
        areas = new double[balls.size()];
        double sum = 0;
        for (int i = 0; i < areas.length; i++) {
            sum += 4 * Math.PI * balls.get(i).radius() * balls.get(i).radius();
            areas[i] = sum;
        }
        allAreas = sum;
        g0 = direction(scene, 0, 0);
        gx = direction(scene, 1, 0).minus(g0);
        gy = direction(scene, 0, 1).minus(g0);
        det = g0.dot(gx.cross(gy));
        eye = new Vec3(ray.ox, ray.oy, ray.oz);
    }

    private Vec3 direction(CompiledScene scene, double x, double y) {
        scene.camera.ray(x, y, ray);
        return new Vec3(ray.dx, ray.dy, ray.dz);
    }

    @Override
    public void stopWhen(BooleanSupplier condition) {
        cancelled = condition;
    }

    @Override
    public double expectedContribution() {
        return balls.isEmpty() ? 0 : radiance;
    }

    @Override
    public void trace(long firstPath, int paths, SplatBatch out) {
        for (long path = firstPath; path < firstPath + paths && !balls.isEmpty(); path++) {
            if (cancelled.getAsBoolean()) {
                throw new CancellationException();
            }
            trace(path, out);
        }
    }

    private void trace(long path, SplatBatch out) {
        long hash = Hash.of(seed, path);
        double area = allAreas * Hash.unit(Hash.of(hash, BALL));
        int i = 0;
        while (i < areas.length - 1 && area >= areas[i]) {
            i++;
        }
        SpherePrimitive ball = balls.get(i);
        double up = 2 * Hash.unit(Hash.of(hash, HEIGHT)) - 1;
        double turn = 2 * Math.PI * Hash.unit(Hash.of(hash, TURN));
        double across = Math.sqrt(1 - up * up);
        Vec3 normal = new Vec3(across * StrictMath.cos(turn), up, across * StrictMath.sin(turn));
        Vec3 point = ball.center().plus(normal.times(ball.radius()));
        Vec3 toEye = eye.minus(point);
        double distance = toEye.length();
        double cosine = normal.dot(toEye) / distance;
        // p − eye = s·(g₀ + x·gₓ + y·g_y), by Cramer's rule.
        Vec3 q = point.minus(eye);
        double s = q.dot(gx.cross(gy)) / det;
        if (!(cosine > 0) || !(s > 0)) {
            return;
        }
        double x = g0.dot(q.cross(gy)) / det / s;
        double y = g0.dot(gx.cross(q)) / det / s;
        counters.shadowRays++;
        ray.set(point.x(), point.y(), point.z(), toEye.x(), toEye.y(), toEye.z(), 0)
                .from(ball, Ray.OUTSIDE);
        if (tracer.trace(ray, hit) && tracer.light == null && hit.t < 1) {
            return;
        }
        double g = distance / s;
        double worth = radiance * allAreas * cosine / (distance * distance) * g * g * g / Math.abs(det);
        out.add(x * width, y * height, worth, worth, worth);
    }
}
