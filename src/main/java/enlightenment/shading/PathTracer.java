package enlightenment.shading;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.GlossyReflection;
import enlightenment.bsdf.Lambert;
import enlightenment.bsdf.Scattering;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.PhysicalScene;
import enlightenment.compiled.RayCounters;
import enlightenment.compiled.SurfaceMaterial;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Hash;
import enlightenment.sampling.Sampler;
import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * The radiance seen along one camera ray, by the rendering equation: a path is followed from surface to surface, at each of them direct
 * light is added, and Russian roulette ends it (J. Kajiya, "The rendering equation", 1986; E. Veach's thesis, 1997).
 *
 * <p>What a path finds twice, by sampling a light and by running into it, is weighted so that both together count once
 * ({@link PathLight}). Nothing is clamped: the mean over paths is the solution. See docs/physical-light.md.
 */
public final class PathTracer implements Shader {
    /** From this scattering event on roulette may end a path. */
    static final int ROULETTE_FROM = 5;

    /** Sooner, if less than this is left of a path's throughput. */
    static final double FAINT = 0.05;

    /** Paths of a closed white room must end, too. */
    static final double LARGEST_SURVIVAL = 0.99;

    private final PhysicalScene physical;
    private final PathFollower path;
    private final PathLight light;
    private final boolean absorbs;
    private final boolean hasCausticPass;

    /** What finds caustics that are seen in mirrors; null if nothing does. */
    private final MirrorCaustics mirrors;

    private final double[] surface = new double[3];
    private final Ray shareRay = new Ray();
    private final double[] pair = new double[2];
    private final Scattering border = new Scattering();

    private final boolean isAlbedo;

    /** Whether a path ends where light has come to its first vertex straight. */
    private final boolean endsSoon;

    private double throughputR;
    private double throughputG;
    private double throughputB;
    private double red;
    private double green;
    private double blue;

    /** Where the path is cut; null for a path that is whole. */
    private PathCut cut;

    /** Whether no random number has had a part in the path so far. */
    private boolean certain;

    /** What was added until then. */
    private double certainRed;

    private double certainGreen;
    private double certainBlue;

    /** Whether that ended at a matte surface of which the lights are certain. */
    private boolean lightIsCertain;

    /** What the path came to until then. */
    private long certainKey;

    /** How many scattering events have used random numbers: the address of the next ones. */
    private int address;

    /** How many scattering events there were. */
    private int events;

    /** Whether a direction was sampled from a lobe that is not a delta lobe. */
    private boolean scattered;

    /** Whether that was the first event of the path. */
    private boolean scatteredFirst;

    /** Whether there were events of delta lobes before. */
    private boolean deltaFirst;

    /** Whether the last event was one of a delta lobe. */
    private boolean delta;

    /** Whether light was gathered at the last vertex, so that light that the path runs into is weighted. */
    private boolean gathered;

    /** The index of refraction of the medium that the eye is in. */
    private double firstIndex;

    /** Radiance at the eye per radiance here, where the index of refraction is another one. */
    private double compression;

    /** A path tracer for one thread that follows whole paths. */
    public PathTracer(CompiledScene scene, RayCounters counters) {
        this(scene, counters, PathPart.WHOLE);
    }

    /**
     * A path tracer for one thread.
     *
     * @param scene a scene of physical shading
     * @param counters what this thread counts
     * @param part what is wanted of each path
     */
    public PathTracer(CompiledScene scene, RayCounters counters, PathPart part) {
        this(scene, counters, part, scene.physical.hasCausticPass());
    }

    /** @param leavesOut whether what a pass of caustics makes is left out, and what it cannot make is sought in its own way */
    PathTracer(CompiledScene scene, RayCounters counters, boolean leavesOut) {
        this(scene, counters, PathPart.WHOLE, leavesOut);
    }

    private PathTracer(CompiledScene scene, RayCounters counters, PathPart part, boolean leavesOut) {
        isAlbedo = part == PathPart.ALBEDO;
        endsSoon = part != PathPart.WHOLE;
        physical = scene.physical;
        path = new PathFollower(scene, counters, physical.maxBounces);
        path.tracer.leaveVisibilityOpen();
        light = new PathLight(scene, counters, path);
        absorbs = physical.hasAbsorption;
        hasCausticPass = leavesOut;
        mirrors = leavesOut && !endsSoon ? MirrorCaustics.of(scene, counters, path) : null;
    }

    @Override
    public void beginTile(double x0, double y0, double x1, double y1) {
        path.tracer.beginTile(x0, y0, x1, y1);
    }

    @Override
    public boolean seesNothing() {
        return path.tracer.seesNothing();
    }

    @Override
    public void stopWhen(BooleanSupplier condition) {
        path.poll.stopWhen(condition);
    }

    @Override
    public void shade(Ray ray, Sampler sampler, double[] out) {
        begin(ray);
        while (step(ray, sampler)) {
            events++;
        }
        out[0] = red;
        out[1] = green;
        out[2] = blue;
    }

    /**
     * Follows a path no further than {@link #certain} takes it, which tells the same after it as after {@link #shade}.
     *
     * @param ray the camera ray, within the tile; the path overwrites it
     */
    public void glimpse(Ray ray, Sampler sampler) {
        begin(ray);
        while (step(ray, sampler) && certain) {
            events++;
        }
    }

    /**
     * The part of the last path's value that is not left to chance: emission that is seen directly or in mirrors, and at the first
     * matte surface the light of lamps that nothing can hide there, or that are points. No random number has a part in it but the place
     * on the film.
     *
     * @param out receives red, green and blue
     * @return a hash of what was met on the way there, and of which lamps are hidden, in full view, or neither: two paths with the same
     *     have met the same, but for one case in 2⁶⁴
     */
    public long certain(double[] out) {
        out[0] = certainRed;
        out[1] = certainGreen;
        out[2] = certainBlue;
        return certain ? path.key : certainKey;
    }

    /**
     * As {@link #shade}, for a path that may be shared.
     *
     * @param out receives the path: its value is what {@link #connect} makes of it
     */
    public void shade(Ray ray, Sampler sampler, PathCut out) {
        cut = out;
        cut.clear();
        begin(ray);
        while (step(ray, sampler)) {
            events++;
        }
        if (cut.gives) {
            cut.given[0] = red;
            cut.given[1] = green;
            cut.given[2] = blue;
        } else {
            cut.own[0] = red;
            cut.own[1] = green;
            cut.own[2] = blue;
        }
        cut = null;
    }

    /** Notes the first vertex: others may give to it if it is sure that its path goes on. */
    private void noteFirst() {
        cut.takes = path.glass.isPlain()
                && PathCut.isOpen(path.hit)
                && Math.max(surface[0], Math.max(surface[1], surface[2])) >= FAINT;
        if (cut.takes) {
            cut.first.set(path.hit);
            System.arraycopy(surface, 0, cut.albedo, 0, 3);
        }
    }

    /** Cuts the path at its second vertex: from here on it is worth what leaves this. */
    private void cutHere() {
        cut.gives = cut.takes && path.glass.isPlain() && path.hit.primitive.isFlat();
        if (cut.gives) {
            cut.second.set(path.hit);
            cut.own[0] = red;
            cut.own[1] = green;
            cut.own[2] = blue;
            red = 0;
            green = 0;
            blue = 0;
            throughputR = 1;
            throughputG = 1;
            throughputB = 1;
        }
    }

    /**
     * How much of what the second vertex of a path gives goes to the first vertex of another, in proportion to others; 0 if that does not see
     * it. It is the density per area, but for a factor, with which paths from there would have found it.
     */
    public double connect(PathCut from, PathCut to) {
        if (!from.takes || !to.gives) {
            return 0;
        }
        Hit a = from.first;
        Hit b = to.second;
        double dx = b.px - a.px;
        double dy = b.py - a.py;
        double dz = b.pz - a.pz;
        double dd = dx * dx + dy * dy + dz * dz;
        double leaving = (a.nx * dx + a.ny * dy + a.nz * dz) * a.side;
        double arriving = -(b.nx * dx + b.ny * dy + b.nz * dz) * b.side;
        if (!(leaving > 0 && arriving > 0)) {
            return 0;
        }
        if (from != to) {
            shareRay.set(a.px, a.py, a.pz, dx, dy, dz, 0).from(a.primitive, a.side);
            shareRay.alsoFrom(b.primitive, b.side);
            if (path.tracer.occluded(shareRay, 1)) {
                return 0;
            }
        }
        return leaving / dd * (arriving / dd);
    }

    /** Whether the last path began at a matte surface at which no lamp's light is left to chance. */
    public boolean isLightCertain() {
        return lightIsCertain;
    }

    /** How many scattering events the last path had. */
    public int events() {
        return events;
    }

    private void begin(Ray ray) {
        red = 0;
        green = 0;
        blue = 0;
        throughputR = 1;
        throughputG = 1;
        throughputB = 1;
        address = 0;
        events = 0;
        scattered = false;
        scatteredFirst = false;
        deltaFirst = false;
        delta = false;
        gathered = false;
        compression = 1;
        certain = true;
        lightIsCertain = false;
        certainRed = 0;
        certainGreen = 0;
        certainBlue = 0;
        if (mirrors != null) {
            mirrors.begin();
        }
        path.begin(ray);
        firstIndex = path.glass.indexOfRefraction();
    }

    /** Follows the ray to the next event; returns whether the path goes on. */
    private boolean step(Ray ray, Sampler sampler) {
        SurfaceMaterial medium = absorbs ? path.medium() : null;
        PathFollower.Event event = path.next(ray);
        if (event == PathFollower.Event.NOTHING) {
            if (!isAlbedo) {
                add(physical.backgroundR, physical.backgroundG, physical.backgroundB);
                addCertain(physical.backgroundR, physical.backgroundG, physical.backgroundB);
            }
            return false;
        }
        if (medium != null && medium.absorbs) {
            absorb(medium, path.distance(ray));
        }
        return event == PathFollower.Event.SURFACE ? surface(ray, sampler) : glass(ray, sampler);
    }

    /** At an opaque surface. */
    private boolean surface(Ray ray, Sampler sampler) {
        SurfaceMaterial material = path.material();
        if (material.glows && !isAlbedo) {
            glow(ray, material);
        }
        if (material.isBlack || !path.mayScatter() || endsSoon && scattered) {
            return false;
        }
        path.color(material, surface);
        if (isAlbedo && !material.isDelta) {
            return albedo(ray, material);
        }
        if (material.bsdf == Lambert.INSTANCE) {
            return matte(ray, sampler);
        }
        return material.isDelta ? reflect(ray, material, sampler) : rough(ray, material, sampler);
    }

    /** Adds what the surface emits. */
    private void glow(Ray ray, SurfaceMaterial material) {
        double weight = 1;
        if (gathered) {
            weight = light.weight(ray);
        } else if (scattered) {
            weight = weightOfCaustic();
        }
        if (weight > 0 && material.glowsTo(path.hit.side)) {
            add(weight * material.glowR, weight * material.glowG, weight * material.glowB);
            addCertain(material.glowR, material.glowG, material.glowB);
        }
    }

    /** Of light that was reflected by a mirror or refracted on its way to a matte surface. */
    private double weightOfCaustic() {
        if (hasCausticPass && scatteredFirst) {
            return 0;
        }
        return mirrors == null ? 1 : mirrors.weight();
    }

    /** Whether the eye sees the surface that the path is at, or that from which it came, in a mirror or through glass. */
    private boolean isSeenByMirrors() {
        return mirrors != null && (scattered ? !scatteredFirst : deltaFirst);
    }

    /** Adds light that balls reflect to the surface. */
    private void gatherMirrored(Bsdf bsdf, Scattering s, Sampler sampler) {
        mirrors.gather(bsdf, s, sampler, address);
        add(mirrors.red, mirrors.green, mirrors.blue);
    }

    /** Ends the path with the reflectance of the surface that it is at, whose colour is known. */
    private boolean albedo(Ray ray, SurfaceMaterial material) {
        if (material.bsdf instanceof GlossyReflection metal) {
            Scattering s = path.arrive(ray, surface);
            metal.reflectAtNormal(s);
            surface[0] = s.valueR;
            surface[1] = s.valueG;
            surface[2] = s.valueB;
        }
        red = throughputR * surface[0];
        green = throughputG * surface[1];
        blue = throughputB * surface[2];
        return false;
    }

    /** Lambert's law: direct light has closed forms. */
    private boolean matte(Ray ray, Sampler sampler) {
        // Counted with panes, which are no events: what is shared has come straight.
        if (cut != null && path.surfaces < 2) {
            if (path.surfaces == 0) {
                noteFirst();
            } else {
                cutHere();
            }
        }
        light.gatherMatte(sampler, address, !scattered);
        add(surface[0] * light.red, surface[1] * light.green, surface[2] * light.blue);
        if (certain) {
            addCertain(surface[0] * light.certainRed, surface[1] * light.certainGreen, surface[2] * light.certainBlue);
            leaveToChance(light.views);
            lightIsCertain = light.isCertain();
        }
        boolean seen = isSeenByMirrors();
        if (seen) {
            gatherMirrored(Lambert.INSTANCE, path.arrive(ray, surface), sampler);
        }
        sampler.pair(address++, Sampler.Purpose.DIRECTION, pair);
        Scattering s = path.scatterMatte(ray, pair[0], pair[1]);
        light.left(s.pdf);
        if (seen) {
            mirrors.left(s);
        }
        leave(false);
        return s.pdf > 0 && filterAndSurvive(surface[0], surface[1], surface[2], sampler) && path.goesOn();
    }

    private boolean reflect(Ray ray, SurfaceMaterial material, Sampler sampler) {
        if (mirrors != null) {
            mirrors.reflected(path.id);
        }
        path.scatter(ray, material, surface, 0, 0, 0);
        leave(true);
        return filterAndSurvive(surface[0], surface[1], surface[2], sampler) && path.goesOn();
    }

    /** Any other lobes. */
    private boolean rough(Ray ray, SurfaceMaterial material, Sampler sampler) {
        leaveToChance(0);
        Scattering s = path.arrive(ray, surface);
        light.gather(material.bsdf, s, sampler, address, !scattered);
        add(light.red, light.green, light.blue);
        boolean seen = isSeenByMirrors();
        if (seen) {
            gatherMirrored(material.bsdf, s, sampler);
        }
        sampler.pair(address, Sampler.Purpose.DIRECTION, pair);
        if (!material.bsdf.sample(s, pair[0], pair[1], sampler.unit(address++, Sampler.Purpose.CHOICE))) {
            return false;
        }
        light.left(s.pdf);
        if (seen) {
            mirrors.left(s);
        }
        path.leave(ray, s);
        leave(s.delta);
        return filterAndSurvive(s.valueR, s.valueG, s.valueB, sampler) && path.goesOn();
    }

    /** At a border of glass, or at a pane. */
    private boolean glass(Ray ray, Sampler sampler) {
        leaveToChance(0);
        sampler.pair(address, Sampler.Purpose.CHOICE, pair);
        double choice = pair[0];
        if (physical.hasPartialGlass) {
            int opaque = path.glass.opaque(pair[1]);
            if (opaque >= 0) {
                path.turnTo(opaque);
                path.color(path.material(), surface);
                if (!path.mayScatter() || endsSoon && scattered) {
                    return false;
                }
                return isAlbedo ? albedo(ray, path.material()) : matte(ray, sampler);
            }
        }
        boolean isRough = false;
        if (physical.hasRoughGlass) {
            isRough = gatherAtBorder(ray, sampler);
            sampler.pair(address, Sampler.Purpose.DIRECTION, pair);
        }
        address++;
        path.glass.choose(choice, pair);
        boolean through = path.cross(ray);
        Arrays.fill(surface, path.glass.weight());
        if (through) {
            path.filter(surface);
        }
        if (mirrors != null) {
            mirrors.begin();
        }
        double n = path.glass.indexOfRefraction();
        compression = firstIndex * firstIndex / (n * n);
        if (path.glass.passedStraight()) {
            // No event: a path may be cut into any number of pieces. Shadow rays pass, too, so that the last vertex
            // stays what it was.
            events--;
            deltaFirst |= !scattered;
            filter(surface[0], surface[1], surface[2]);
            return path.goesOn();
        }
        if (endsSoon && scattered) {
            return false;
        }
        leave(true);
        if (isRough) {
            gathered = true;
            light.left(path.glass.border.pdf);
        }
        return filterAndSurvive(surface[0], surface[1], surface[2], sampler) && path.goesOn();
    }

    /** Adds direct light if the path is at a rough border; returns whether it is. */
    private boolean gatherAtBorder(Ray ray, Sampler sampler) {
        Bsdf bsdf = path.mayScatter() ? path.roughBorder(ray, border) : null;
        if (bsdf == null) {
            return false;
        }
        Arrays.fill(surface, 1);
        path.filter(surface);
        path.turnTo(0);
        light.gatherAtBorder(bsdf, border, surface, sampler, address, !scattered);
        add(light.red, light.green, light.blue);
        return true;
    }

    /** Notes the kind of event that the path leaves behind. */
    private void leave(boolean isDelta) {
        if (!isDelta && !scattered) {
            scattered = true;
            scatteredFirst = !deltaFirst;
        }
        deltaFirst |= !scattered;
        delta = isDelta;
        gathered = !isDelta;
    }

    private void add(double r, double g, double b) {
        red = Math.fma(throughputR * compression, r, red);
        green = Math.fma(throughputG * compression, g, green);
        blue = Math.fma(throughputB * compression, b, blue);
    }

    private void addCertain(double r, double g, double b) {
        if (certain) {
            certainRed = Math.fma(throughputR, r, certainRed);
            certainGreen = Math.fma(throughputG, g, certainGreen);
            certainBlue = Math.fma(throughputB, b, certainBlue);
        }
    }

    /** From here on random numbers have a part in the path. */
    private void leaveToChance(long views) {
        if (certain) {
            certain = false;
            certainKey = Hash.mix(path.key + views);
        }
    }

    private void filter(double r, double g, double b) {
        throughputR *= r;
        throughputG *= g;
        throughputB *= b;
    }

    /**
     * Multiplies the throughput by the weight of an event and plays roulette by it: by the event's own albedo, since what is left of the
     * path's throughput says little of what is to come.
     */
    private boolean filterAndSurvive(double r, double g, double b, Sampler sampler) {
        filter(r, g, b);
        double most = Math.max(throughputR, Math.max(throughputG, throughputB));
        if (events + 1 < ROULETTE_FROM && most >= FAINT) {
            return true;
        }
        leaveToChance(0);
        if (!(most > 0)) {
            return false;
        }
        double survival = Math.min(Math.max(r, Math.max(g, b)), LARGEST_SURVIVAL);
        if (!(sampler.unit(events, Sampler.Purpose.ROULETTE) < survival)) {
            return false;
        }
        double scale = 1 / survival;
        throughputR *= scale;
        throughputG *= scale;
        throughputB *= scale;
        return true;
    }

    /** By Beer and Lambert's law, on the way to what the path has come to. */
    private void absorb(SurfaceMaterial medium, double length) {
        throughputR *= StrictMath.exp(-medium.absorptionR * length);
        throughputG *= StrictMath.exp(-medium.absorptionG * length);
        throughputB *= StrictMath.exp(-medium.absorptionB * length);
    }
}
