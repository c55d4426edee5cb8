package enlightenment.shading;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.PhysicalLight;
import enlightenment.compiled.PhysicalScene;
import enlightenment.compiled.RayCounters;
import enlightenment.compiled.SurfaceMaterial;
import enlightenment.compiled.Tracer;
import enlightenment.frame.Basis;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.sampling.Sampler;
import enlightenment.sampling.Warp;
import java.util.ArrayList;
import java.util.List;

/**
 * Caustics of balls that are mirrors, as they are seen in a mirror or through glass: paths from lights cannot bring them to the eye, and
 * paths from the eye find them by chance. At a surface that the eye sees so, each ball shows each light in a small cone of directions
 * ({@link SphereMirror}); some are chosen there and followed over the ball to the light. What the path that goes on finds in the same cone
 * is left out: so both together count once, however well the cone covers the light. (The idea is that of specular manifold sampling, T.
 * Zeltner, I. Georgiev, W. Jakob 2020, where the manifold is known.)
 */
final class MirrorCaustics {
    /** With more pairs of a ball and a light this is no longer worth its while. */
    private static final int MOST_PAIRS = 8;

    /** Keeps the numbers of directions apart from those of the path's own. */
    private static final int ADDRESSES = 1 << 24;

    private final CompiledScene scene;
    private final RayCounters counters;
    private final PathFollower path;
    private final Tracer tracer;
    private final SpherePrimitive[] balls;
    private final int[] ballIds;
    private final PhysicalLight[] lights;
    private final SphereMirror mirror = new SphereMirror();
    private final Basis basis = new Basis();
    private final Scattering own = new Scattering();
    private final Scattering there = new Scattering();
    private final Ray ray = new Ray();
    private final Hit hit = new Hit();
    private final double[] point = new double[3];
    private final double[] color = new double[3];

    /** By pair: the cone. */
    private final double[] axisX;

    private final double[] axisY;
    private final double[] axisZ;
    private final double[] cosines;

    /** The pairs whose cones hold the direction in which the path left; 0 if there are none, or it has left another surface since. */
    private int covered;

    /** The ball that the path has come to in that direction, or -1. */
    private int ball = -1;

    /** What was gathered: radiance towards where the path came from. */
    double red;

    double green;
    double blue;

    private MirrorCaustics(
            CompiledScene scene, RayCounters counters, PathFollower path, List<Integer> ids, PhysicalLight[] lights) {
        this.scene = scene;
        this.counters = counters;
        this.path = path;
        this.lights = lights;
        tracer = path.tracer;
        ballIds = ids.stream().mapToInt(id -> id).toArray();
        balls = ids.stream().map(id -> (SpherePrimitive) scene.primitives[id]).toArray(SpherePrimitive[]::new);
        int pairs = balls.length * lights.length;
        axisX = new double[pairs];
        axisY = new double[pairs];
        axisZ = new double[pairs];
        cosines = new double[pairs];
    }

    /** Those of a scene; null where there are none that this can find, or too many. */
    static MirrorCaustics of(CompiledScene scene, RayCounters counters, PathFollower path) {
        PhysicalScene physical = scene.physical;
        List<Integer> ids = new ArrayList<>();
        for (int id = 0; id < scene.primitives.length && ids.size() <= MOST_PAIRS; id++) {
            Primitive p = scene.primitives[id];
            SurfaceMaterial material = scene.material(id, 0);
            if (p instanceof SpherePrimitive && material.isDelta && !material.isGlass && !material.isBlack) {
                ids.add(id);
            }
        }
        long pairs = (long) ids.size() * physical.lights.length;
        return pairs > 0 && pairs <= MOST_PAIRS
                ? new MirrorCaustics(scene, counters, path, ids, physical.lights)
                : null;
    }

    /** Forgets what the path has left. */
    void begin() {
        covered = 0;
    }

    /**
     * Gathers the light at the surface that the path is at, in empty space.
     *
     * @param s the surface, with its colour
     */
    void gather(Bsdf bsdf, Scattering s, Sampler sampler, int address) {
        red = 0;
        green = 0;
        blue = 0;
        covered = 0;
        boolean isPossible = path.mayScatterTwice() && path.medium() == null;
        for (int pair = 0; pair < cosines.length; pair++) {
            cosines[pair] = 2;
            PhysicalLight l = lights[pair % lights.length];
            if (isPossible && !l.isPoint && ballIds[pair / lights.length] != path.id) {
                aim(pair, balls[pair / lights.length], l);
                if (cosines[pair] <= 1) {
                    sampler.pair(ADDRESSES + address * MOST_PAIRS + pair, Sampler.Purpose.DIRECTION, point);
                    follow(pair, bsdf, s);
                }
            }
        }
    }

    private void aim(int pair, SpherePrimitive b, PhysicalLight l) {
        Hit at = path.hit;
        mirror.aim(
                b.center().x() - at.px,
                b.center().y() - at.py,
                b.center().z() - at.pz,
                b.radius(),
                l.ballX - at.px,
                l.ballY - at.py,
                l.ballZ - at.pz,
                l.ballRadius);
        cosines[pair] = mirror.cosine;
        axisX[pair] = mirror.wx;
        axisY[pair] = mirror.wy;
        axisZ[pair] = mirror.wz;
    }

    private void follow(int pair, Bsdf bsdf, Scattering s) {
        copy(s);
        Warp.toDisk(point[0], point[1], point);
        double height = mirror.oneMinusCosine;
        double spread = Math.sqrt(height * (2 - point[2] * height));
        basis.around(mirror.wx, mirror.wy, mirror.wz);
        double a = point[0] * spread;
        double b = point[1] * spread;
        double c = 1 - point[2] * height;
        own.ix = a * basis.ax + b * basis.bx + c * mirror.wx;
        own.iy = a * basis.ay + b * basis.by + c * mirror.wy;
        own.iz = a * basis.az + b * basis.bz + c * mirror.wz;
        bsdf.evaluate(own);
        if ((own.valueR > 0 || own.valueG > 0 || own.valueB > 0) && meets(pair)) {
            double angle = 2 * Math.PI * height;
            PhysicalLight l = lights[pair % lights.length];
            red += angle * own.valueR * there.valueR * l.r;
            green += angle * own.valueG * there.valueG * l.g;
            blue += angle * own.valueB * there.valueB * l.b;
        }
    }

    private void copy(Scattering s) {
        own.ox = s.ox;
        own.oy = s.oy;
        own.oz = s.oz;
        own.nx = s.nx;
        own.ny = s.ny;
        own.nz = s.nz;
        own.red = s.red;
        own.green = s.green;
        own.blue = s.blue;
    }

    /** Whether the direction leads over the ball to the light; then the ball's reflection is set. */
    private boolean meets(int pair) {
        Hit at = path.hit;
        counters.mirrorRays++;
        ray.set(at.px, at.py, at.pz, own.ix, own.iy, own.iz, 0).from(at.primitive, at.side);
        if (path.glass.surfaces() > 1) {
            path.glass.startOnAll(ray);
        }
        int id = ballIds[pair / lights.length];
        if (!tracer.trace(ray, hit) || tracer.id != id || hit.side != Ray.OUTSIDE) {
            return false;
        }
        SurfaceMaterial material = scene.material(id, hit.face);
        hit.primitive.textureCoordinates(hit);
        material.color(hit.u, hit.v, true, color);
        there.red = color[0];
        there.green = color[1];
        there.blue = color[2];
        Optics.arrive(there, ray, hit);
        if (!material.bsdf.sample(there, 0, 0, 0)) {
            return false;
        }
        Optics.leave(ray, hit, there);
        PhysicalLight l = lights[pair % lights.length];
        return tracer.trace(ray, hit)
                && tracer.id == l.id
                && hit.face == l.face
                && scene.material(l.id, l.face).glowsTo(hit.side);
    }

    /** The path has left the surface in a direction. */
    void left(double dx, double dy, double dz) {
        covered = 0;
        ball = -1;
        for (int pair = 0; pair < cosines.length; pair++) {
            if (dx * axisX[pair] + dy * axisY[pair] + dz * axisZ[pair] >= cosines[pair]) {
                covered |= 1 << pair;
            }
        }
    }

    /** The path is reflected by a primitive. */
    void reflected(int id) {
        if (ball >= 0) {
            covered = 0;
        }
        ball = id;
    }

    /** Whether the light that the path has come to was gathered before. */
    boolean covers(int light) {
        for (int pair = 0; covered != 0 && pair < cosines.length; pair++) {
            if ((covered >> pair & 1) != 0 && pair % lights.length == light && ballIds[pair / lights.length] == ball) {
                return true;
            }
        }
        return false;
    }
}
