package enlightenment.transport.image;

import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.world.CompiledScene;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Finds where the eye sees the ball around a light by a {@link SpecularChain}: through glass that refracts, or in several mirrors. Camera
 * rays to each mirror and solid of glass are followed along all chains that leave enough of the light.
 */
final class ChainImages extends ImageSolver {
    /** Chains of so many events at most. */
    private static final int LONGEST = 8;

    /** Chains that leave less than this are not followed: three reflections at glass, or more. */
    private static final double FAINTEST = 0x1p-10;

    /** So many camera rays in all, and of all moments of a picture, but at least a few for each mirror. */
    private static final int RAYS = 1 << 13;

    private static final int LARGEST_GRID = 32;
    private static final int SMALLEST_GRID = 8;

    /** So many lights are looked at, the first ones. */
    private static final int MOST_LIGHTS = 32;

    /** So many events are followed: where chains are long or many, the last mirrors are not looked at. */
    private static final int MOST_EVENTS = 1 << 19;

    /** The same for each of many moments. */
    private static final int LEAST_EVENTS = 1 << 13;

    /** Of a mirror so many pairs of chain and light, the first ones. */
    private static final int MOST_SEEN = 512;

    private record Seen(long chain, int light) {}

    private final SpecularChain chains;
    private final Ray ray = new Ray();
    private final int[] lights;
    private final int[] mirrors;

    /** What is sought. */
    private Seen sought;

    /** The square of how far the rays of a grid pass from a light, by how they get there. */
    private final Map<Seen, double[]> squares = new LinkedHashMap<>();

    private int side;
    private int events;
    private final int mostEvents;

    ChainImages(CompiledScene scene) {
        super(scene);
        chains = new SpecularChain(scene, new RayCounters(scene.kindNames.size()));
        chains.beginTile(0, 0, 1, 1);
        mostEvents = Math.max(MOST_EVENTS / scene.momentsOfPicture(), LEAST_EVENTS);
        List<Integer> bright = new ArrayList<>();
        for (int k = 0; k < scene.physical.lights.length && bright.size() < MOST_LIGHTS; k++) {
            PhysicalLight l = scene.physical.lights[k];
            if (!l.isPoint && LightImage.brightness(l) > 0) {
                bright.add(k);
            }
        }
        lights = bright.stream().mapToInt(k -> k).toArray();
        mirrors = arePossible() ? mirrors() : new int[0];
    }

    /** With dispersion each wavelength has images of its own, and from within a medium none are sampled. */
    private boolean arePossible() {
        return scene.physical.maxBounces > 0
                && scene.physical.showsMirrored
                && !scene.physical.hasDispersion
                && scene.physical.around == null
                && lights.length > 0;
    }

    private int[] mirrors() {
        List<Integer> found = new ArrayList<>();
        boolean isLong = false;
        for (int id = 0; id < scene.primitives.length; id++) {
            if (isSpecular(id)) {
                isLong |= canBeMetTwice(id);
                found.add(id);
            }
        }
        return isLong || found.size() > 1 ? found.stream().mapToInt(k -> k).toArray() : new int[0];
    }

    private boolean isSpecular(int id) {
        for (int face = 0; face < scene.primitives[id].faceCount(); face++) {
            SurfaceMaterial m = scene.material(id, face);
            if (m.isDelta && !m.isBlack) {
                return true;
            }
        }
        return false;
    }

    private boolean canBeMetTwice(int id) {
        Primitive p = scene.primitives[id];
        return p.faceCount() > 1 || !p.support(0).isFlat();
    }

    /** The images in the picture that are smaller than a pixel. */
    List<LightImage> find() {
        List<LightImage> found = new ArrayList<>();
        if (mirrors.length == 0) {
            return found;
        }
        side = (int) Math.sqrt((double) RAYS / scene.momentsOfPicture() / mirrors.length);
        side = Math.max(Math.min(side, LARGEST_GRID), SMALLEST_GRID);
        for (int id : mirrors) {
            if (events < mostEvents && lay(scene.primitives[id].bounds(), side)) {
                survey(id);
                solveAll(found);
            }
        }
        return found;
    }

    /** Follows the rays of the grid that come to a primitive first. */
    private void survey(int id) {
        squares.clear();
        for (int cell = 0; cell < side * side && events < mostEvents; cell++) {
            if (comesTo(id, cell)) {
                explore(cell, SpecularChain.STRAIGHT);
            }
        }
    }

    private boolean follow(double atX, double atY, long chain) {
        events += SpecularChain.length(chain) + 1;
        camera.ray(atX, atY, ray);
        return chains.follow(ray, chain);
    }

    private boolean comesTo(int id, int cell) {
        return follow(middleX(cell % side), middleY(cell / side), SpecularChain.STRAIGHT) && chains.isAtPrimitive(id);
    }

    /** Follows a chain, and all longer ones that begin so. */
    private void explore(int cell, long chain) {
        if (!follow(middleX(cell % side), middleY(cell / side), chain)) {
            return;
        }
        boolean isBright = Math.max(chains.red, Math.max(chains.green, chains.blue)) >= FAINTEST;
        boolean mayReflect = chains.goesOn(false);
        boolean mayPass = chains.goesOn(true);
        if (isBright && SpecularChain.length(chain) > 0 && chains.isOwn(chain)) {
            note(cell, chain);
        }
        if (isBright && SpecularChain.length(chain) < LONGEST) {
            if (mayReflect) {
                explore(cell, SpecularChain.and(chain, false));
            }
            if (mayPass) {
                explore(cell, SpecularChain.and(chain, true));
            }
        }
    }

    private void note(int cell, long chain) {
        for (int k : lights) {
            light = scene.physical.lights[k];
            if (comesNear()) {
                note(cell, new Seen(chain, k));
            }
        }
    }

    private void note(int cell, Seen seen) {
        double[] known = squares.get(seen);
        if (known == null && squares.size() < MOST_SEEN) {
            known = nowhere();
            squares.put(seen, known);
        }
        if (known != null) {
            known[cell] = square();
        }
    }

    private double[] nowhere() {
        double[] all = new double[side * side];
        Arrays.fill(all, Double.POSITIVE_INFINITY);
        return all;
    }

    /** Whether the ray after the chain has the light before it, and nothing else. */
    private boolean comesNear() {
        double scale = 1 / Math.sqrt(ray.dd);
        return passes(
                        Math.fma(ray.tMin, ray.dx, ray.ox),
                        Math.fma(ray.tMin, ray.dy, ray.oy),
                        Math.fma(ray.tMin, ray.dz, ray.oz),
                        scale * ray.dx,
                        scale * ray.dy,
                        scale * ray.dz)
                && chains.distance(ray) >= ahead - light.ballRadius;
    }

    @Override
    boolean misses(double atX, double atY) {
        return follow(atX, atY, sought.chain) && chains.isOwn(sought.chain) && comesNear();
    }

    private void solveAll(List<LightImage> found) {
        for (Map.Entry<Seen, double[]> e : squares.entrySet()) {
            sought = e.getKey();
            light = scene.physical.lights[sought.light];
            for (int cell = 0; cell < side * side && events < mostEvents; cell++) {
                if (solve(e.getValue(), side, cell % side, cell / side)) {
                    keep(found);
                }
            }
        }
    }

    /** Keeps the image that was found, unless it overlaps one of the same kind: paths from there would count twice. */
    private void keep(List<LightImage> found) {
        double share = Math.max(chains.red * light.r, Math.max(chains.green * light.g, chains.blue * light.b));
        LightImage image = new LightImage(sought.light, share, sought.chain, x, y);
        boolean isNew =
                found.stream().noneMatch(o -> o.light == image.light && o.isSeenBy(image.chain) && o.overlaps(image));
        if (share > 0 && image.area() < 1 && isNew) {
            found.add(image);
        }
    }
}
