package enlightenment.transport.path;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Lambert;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.direct.PathLight;
import enlightenment.transport.image.MirrorCaustics;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.BandMixing;
import enlightenment.transport.state.PathHistory;
import enlightenment.transport.state.PathPart;
import enlightenment.transport.state.PathValue;
import enlightenment.world.CompiledScene;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;

/**
 * The radiance seen along one camera ray, by the rendering equation: a path is followed from surface to surface, at each of them direct
 * light is added, and Russian roulette ends it (J. Kajiya, "The rendering equation", 1986; E. Veach's thesis, 1997). What a path finds
 * twice, by sampling a light and by running into it, is weighted so that both together count once ({@link PathLight}). Nothing is
 * clamped: the mean over paths is the solution. See docs/physical-light.md.
 */
public final class PathTracer extends EyePathTracer {
    private final PathLight light;
    private final boolean hasCausticPass;

    /** Whether the caustic pass also covers near-specular lobes. */
    private final boolean causticPassCoversGlossy;

    /** What finds caustics that are seen in mirrors; null if nothing does. */
    private final MirrorCaustics mirrors;

    private final PathHistory history = new PathHistory();
    private final PathConnections connections;
    private final boolean isAlbedo;

    /** Follows paths through media that scatter light; null if there are none. */
    private final RandomWalk walk;

    /** Whether paths stop after direct lighting at their first non-specular vertex. */
    private final boolean directOnly;

    /** Where the path is cut; null for a path that is whole. */
    private PathCut cut;

    /** For one thread that follows whole paths. */
    public PathTracer(CompiledScene scene, RayCounters counters) {
        this(scene, counters, PathPart.WHOLE);
    }

    /** For one thread, which counts there, and a scene of physical shading; of each path this part is wanted. */
    public PathTracer(CompiledScene scene, RayCounters counters, PathPart part) {
        this(scene, counters, part, scene.physical.hasCausticPass());
    }

    /** @param leavesOut whether what a pass of caustics makes is left out, and what it cannot make is sought in its own way */
    public PathTracer(CompiledScene scene, RayCounters counters, boolean leavesOut) {
        this(scene, counters, PathPart.WHOLE, leavesOut);
    }

    private PathTracer(CompiledScene scene, RayCounters counters, PathPart part, boolean leavesOut) {
        super(scene, counters, new PathValue(BandMixing.of(scene.physical)), showsLamps(part));
        isAlbedo = part == PathPart.ALBEDO;
        directOnly = part == PathPart.DIRECT || part == PathPart.ALBEDO;
        value.isIndirect = part == PathPart.INDIRECT;
        path.tracer.leaveVisibilityOpen();
        light = new PathLight(scene, counters, path);
        connections = new PathConnections(path.tracer);
        if (isAlbedo) {
            value.wavelength = null;
        }
        hasCausticPass = leavesOut;
        causticPassCoversGlossy = leavesOut && physical.caustics.takesNarrow();
        walk = RandomWalk.of(scene, counters, path, value, part);
        mirrors = leavesOut && !directOnly ? MirrorCaustics.of(scene, counters, path) : null;
    }

    @Override
    public void shade(Ray ray, Sampler sampler, double[] out) {
        follow(ray, sampler);
        value.get(out);
    }

    /**
     * Follows a path no further than {@link #certain} takes it, which tells the same after it as after {@link #shade}.
     *
     * @param ray the camera ray, within the tile; the path overwrites it
     */
    public void glimpse(Ray ray, Sampler sampler) {
        begin(ray, sampler);
        while (step(ray, sampler) && value.certain) {
            history.events++;
        }
    }

    /**
     * The deterministic part of the last path's value, which depends on the position on the film only: emission seen directly or in
     * mirrors, and at the first matte surface the closed-form light of lamps that nothing can occlude there, and of point lights.
     *
     * @param out receives its radiance: red, green and blue, linear
     * @return a 64-bit hash of the surfaces that were hit, and of which lamps are hidden, fully visible or undecided there
     */
    public long certain(double[] out) {
        return value.certain(out, path.key);
    }

    /** As {@link #shade}, for a path that may be shared: {@code out} receives it, worth what {@link #connections} make of it. */
    public void shade(Ray ray, Sampler sampler, PathCut out) {
        cut = out;
        cut.clear();
        follow(ray, sampler);
        value.get(cut.gives ? cut.given : cut.own);
        cut = null;
    }

    private static boolean showsLamps(PathPart part) {
        return part == PathPart.WHOLE || part == PathPart.DIRECT;
    }

    /** What connects paths of this thread that may be shared. */
    public PathConnections connections() {
        return connections;
    }

    /** How many scattering events the last path had. */
    public int events() {
        return history.events;
    }

    private void follow(Ray ray, Sampler sampler) {
        begin(ray, sampler);
        images.gather(sampler, value);
        while (step(ray, sampler)) {
            history.events++;
        }
    }

    private void begin(Ray ray, Sampler sampler) {
        history.begin();
        forgetMirrors();
        beginPath(ray, sampler);
    }

    private void forgetMirrors() {
        if (mirrors != null) {
            mirrors.begin();
        }
    }

    /** Follows the ray to the next event; returns whether the path goes on. */
    private boolean step(Ray ray, Sampler sampler) {
        value.disperse();
        SurfaceMaterial medium = physical.hasAbsorption ? path.medium() : null;
        PathFollower.Event event = walk == null ? path.next(ray) : walk.next(ray, medium, history, sampler);
        if (event == null) {
            return inMedium(ray, sampler);
        }
        if (event == PathFollower.Event.NOTHING) {
            if (!isAlbedo) {
                light.escape(ray, history.gathered, !(hasCausticPass && history.scatteredFirst));
                value.addEscaped(light.gathered, light.hasConstantEnvironment(), path.key);
            }
            return false;
        }
        if (medium != null && medium.absorbs && medium.medium == null) {
            value.absorb(medium, path.distance(ray));
        }
        return event == PathFollower.Event.SURFACE ? surface(ray, sampler) : glass(ray, sampler);
    }

    /** Where a medium scatters the path. */
    private boolean inMedium(Ray ray, Sampler sampler) {
        if (!mayScatter()) {
            return false;
        }
        forgetMirrors();
        return walk.scatter(ray, light, history, sampler, address++) && path.goesOn();
    }

    /** At an opaque surface. */
    private boolean surface(Ray ray, Sampler sampler) {
        SurfaceMaterial material = path.material();
        if (material.glows && !isAlbedo) {
            glow(ray, material);
        }
        if (material.isBlack || !mayScatter()) {
            return false;
        }
        path.color(material, surface);
        if (isAlbedo && !material.isDelta) {
            path.reflectance(ray, material, surface);
            return value.endsWith(surface);
        }
        if (material.bsdf == Lambert.INSTANCE) {
            return material.reradiation == null ? matte(ray, sampler) : fluorescent(ray, material, sampler);
        }
        return material.isDelta ? reflect(ray, material, sampler) : rough(ray, material, sampler);
    }

    /** Whether the path may have one more scattering event. */
    private boolean mayScatter() {
        return path.mayScatter() && goesFurther();
    }

    /** At an event: whether the path goes on if it has been scattered; what it finds from here on is indirect then. */
    private boolean goesFurther() {
        if (history.scattered) {
            value.beginIndirect();
        }
        return !(directOnly && history.scattered);
    }

    /** Adds what the surface emits. */
    private void glow(Ray ray, SurfaceMaterial material) {
        if (cut != null && cut.isLeft(history) && glowAtCut(ray, material)) {
            return;
        }
        double weight = weightOfGlow(ray);
        if (weight > 0 && material.glowsTo(path.hit.side)) {
            value.addEmission(material, weight);
        }
    }

    /** By what share of it light that the surface emits is found here, not in another way. */
    private double weightOfGlow(Ray ray) {
        if (history.gathered || history.atCoincidentSurface) {
            return light.leavesGlow() ? 0 : history.atCoincidentSurface ? 1 : light.weight(ray);
        }
        return history.scattered ? weightOfCaustic() : images.weight();
    }

    /** Tells it to the cut where the path has come straight from there: returns whether light that is sampled there might find it, too. */
    private boolean glowAtCut(Ray ray, SurfaceMaterial material) {
        double density = light.density(ray);
        if (density > 0 && material.glowsTo(path.hit.side)) {
            cut.meet(material, value, density);
        }
        return density > 0;
    }

    /** Of light that was reflected by a mirror or refracted on its way to a matte surface. */
    private double weightOfCaustic() {
        return hasCausticPass && history.scatteredFirst ? 0 : mirrors == null ? 1 : mirrors.weight();
    }

    /**
     * Adds light that balls reflect to the surface if the eye sees this, or the first, in a mirror or through glass; returns whether it
     * does.
     */
    private boolean gatherMirrored(Bsdf bsdf, Ray ray, Sampler sampler) {
        if (mirrors == null || !history.isSeenByMirrors()) {
            return false;
        }
        mirrors.gather(bsdf, path.arrive(ray, surface), sampler, address);
        value.addIndirect(mirrors.red, mirrors.green, mirrors.blue, mirrors.ultraviolet);
        return true;
    }

    /** Lambert's law: direct light has closed forms. */
    private boolean matte(Ray ray, Sampler sampler) {
        if (cut != null && path.surfaces < 2) {
            cut.note(path, surface, value);
        }
        return lambertian(ray, sampler);
    }

    /** The same with a dye: a grey surface, and what light is worth from there on changes. */
    private boolean fluorescent(Ray ray, SurfaceMaterial material, Sampler sampler) {
        if (cut != null && path.surfaces < 2) {
            cut.noteLater(path, value);
        }
        return value.scatter(material.reradiation, surface) && lambertian(ray, sampler);
    }

    private boolean lambertian(Ray ray, Sampler sampler) {
        light.gatherMatte(sampler, address, !history.scattered);
        value.addReflected(light.gathered, surface);
        if (value.certain) {
            value.leaveToChance(path.key + light.gathered.views);
        }
        boolean seen = gatherMirrored(Lambert.INSTANCE, ray, sampler);
        sampler.pair(address++, Sampler.Purpose.DIRECTION, pair);
        Scattering s = path.scatterMatte(ray, pair[0], pair[1]);
        light.setBsdfPdf(s.pdf);
        if (seen) {
            mirrors.left(s);
        }
        history.leave(false);
        return s.pdf > 0 && survives(surface[0], surface[1], surface[2], sampler) && path.goesOn();
    }

    private boolean reflect(Ray ray, SurfaceMaterial material, Sampler sampler) {
        if (mirrors != null) {
            mirrors.reflected(path.id);
        }
        path.scatter(ray, material, surface, 0, 0, 0);
        history.leave(true);
        return survives(surface[0], surface[1], surface[2], sampler) && path.goesOn();
    }

    /** Any other lobes. */
    private boolean rough(Ray ray, SurfaceMaterial material, Sampler sampler) {
        value.leaveToChance(path.key);
        Scattering s = path.arrive(ray, surface);
        boolean isNarrow = causticPassCoversGlossy && material.bsdf.isNarrow();
        // What comes to narrow lobes from narrow lobes is not shared with wide ones: there it is the business of
        // others.
        if (!isNarrow
                && cut != null
                && path.surfaces < 2
                && cut.noteRough(path, material.bsdf, s, value, physical.hasConstantEnvironment())) {
            return leaveCut(ray, material.bsdf, s, sampler);
        }
        light.gather(material.bsdf, s, sampler, address, !history.scattered, isNarrow && history.leavesNarrow());
        value.add(light.gathered);
        boolean seen = gatherMirrored(material.bsdf, ray, sampler);
        sampler.pair(address, Sampler.Purpose.DIRECTION, pair);
        if (!material.bsdf.sample(s, pair[0], pair[1], sampler.unit(address++, Sampler.Purpose.CHOICE))) {
            return false;
        }
        light.setBsdfPdf(s.pdf);
        if (seen) {
            mirrors.left(s);
        }
        path.leave(ray, s);
        if (isNarrow) {
            history.leaveNarrow();
        } else {
            history.leave(s.delta);
        }
        return survives(s.valueR, s.valueG, s.valueB, sampler) && path.goesOn();
    }

    /** Leaves the vertex that the path is cut at, where others share what arrives: what that becomes of is left to them. */
    private boolean leaveCut(Ray ray, Bsdf bsdf, Scattering s, Sampler sampler) {
        light.sample(sampler, address, cut.lamp);
        sampler.pair(address, Sampler.Purpose.DIRECTION, pair);
        if (!bsdf.sample(s, pair[0], pair[1], sampler.unit(address++, Sampler.Purpose.CHOICE))) {
            return false;
        }
        cut.leave(s);
        path.leave(ray, s);
        history.leave(false);
        return path.goesOn();
    }

    /** At a border of glass, or at a pane. */
    private boolean glass(Ray ray, Sampler sampler) {
        value.leaveToChance(path.key);
        sampler.pair(address, Sampler.Purpose.CHOICE, pair);
        double choice = pair[0];
        int opaque = physical.hasPartialGlass ? path.glass.opaque(pair[1]) : -1;
        if (opaque >= 0) {
            return opaquePart(ray, opaque, sampler);
        }
        boolean isRough = false;
        if (physical.hasRoughGlass) {
            isRough = gatherAtBorder(ray, sampler);
            sampler.pair(address, Sampler.Purpose.DIRECTION, pair);
        }
        address++;
        cross(ray, choice);
        forgetMirrors();
        if (path.glass.passedStraight()) {
            // No event: a path may be cut into any number of pieces. Shadow rays pass, too, so that the last vertex
            // stays what it was.
            history.events--;
            value.filter(surface[0], surface[1], surface[2]);
            return path.goesOn();
        }
        if (!goesFurther()) {
            return false;
        }
        history.leave(true);
        if (isRough) {
            history.atCoincidentSurface = path.glass.hasNext();
            history.gathered = !history.atCoincidentSurface;
            light.setBsdfPdf(path.glass.border.pdf);
        }
        boolean survives = walk == null
                ? survives(surface[0], surface[1], surface[2], sampler)
                : walk.survives(surface, sampler, history.events);
        return survives && path.goesOn();
    }

    /** At glass that is opaque in part, where chance says that it is. */
    private boolean opaquePart(Ray ray, int surfaceHere, Sampler sampler) {
        path.turnTo(surfaceHere);
        path.color(path.material(), surface);
        return mayScatter() && (isAlbedo ? value.endsWith(surface) : matte(ray, sampler));
    }

    /** Adds direct light if the path is at a rough border; returns whether it is. */
    private boolean gatherAtBorder(Ray ray, Sampler sampler) {
        Bsdf bsdf = path.mayScatter() ? path.roughBorder(ray, border) : null;
        if (bsdf == null || !goesFurther()) {
            return false;
        }
        Arrays.fill(surface, 1);
        path.filter(surface);
        path.turnTo(0);
        boolean leaves = causticPassCoversGlossy && bsdf.isNarrow() && history.leavesNarrow();
        light.gatherAtBorder(bsdf, border, surface, sampler, address, !history.scattered, leaves);
        value.add(light.gathered);
        return true;
    }

    /** Multiplies by the weight of an event, and plays roulette where it is due. */
    private boolean survives(double r, double g, double b, Sampler sampler) {
        value.filter(r, g, b);
        if (value.isSafe(history.events + 1) || cut != null && cut.takes && path.surfaces == 0) {
            return true;
        }
        value.leaveToChance(path.key);
        return value.survives(r, g, b, sampler, history.events);
    }
}
