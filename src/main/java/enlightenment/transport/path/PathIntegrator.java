package enlightenment.transport.path;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Lambert;
import enlightenment.bsdf.Reradiation;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.direct.NextEventEstimation;
import enlightenment.transport.image.MirrorCaustics;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.BandMixing;
import enlightenment.transport.state.PathEvent;
import enlightenment.transport.state.PathPart;
import enlightenment.transport.state.PathValue;
import enlightenment.transport.state.PathVertex;
import enlightenment.world.CompiledScene;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * The radiance seen along one camera ray, by the rendering equation: a path is followed from surface to surface, at each of them direct
 * light is added, and Russian roulette ends it (J. Kajiya, "The rendering equation", 1986; E. Veach's thesis, 1997). Light that several
 * strategies can sample is combined by multiple importance sampling ({@link enlightenment.transport.state.PathStrategy}). Nothing is clamped:
 * the mean over paths is the solution. See docs/notes/path-tracing.md.
 */
public final class PathIntegrator extends EyePathTracer {
    private final PathVertex vertex = new PathVertex();

    /** Next-event estimation at every vertex but those of delta events. */
    private final NextEventEstimation nextEvent;

    /** The strategy of the caustic pass, whose paths begin at lights; null if the scene has none. */
    private final CausticPassShare causticPass;

    /** The strategy for caustics of mirror balls that the eye sees in mirrors or through glass; null without such balls. */
    private final MirrorCaustics mirrorCaustics;

    private final PathEmission emission;

    /** Follows paths through scattering media; null if there are none. */
    private final RandomWalk walk;

    private final PathConnections connections;
    private final boolean isAlbedo;

    /** Whether paths stop after direct lighting at their first non-specular vertex. */
    private final boolean directOnly;

    private int followed;

    /** Shares light subpaths among paths that are cut; null for none. */
    private LightVertexReuse reuse;

    /** The path to be cut for path reuse; null if it is followed to its end. */
    private PathCut cut;

    /** For one thread that estimates all light of each path. */
    public PathIntegrator(CompiledScene scene, RayCounters counters) {
        this(scene, counters, PathPart.WHOLE);
    }

    /** For one thread and a scene of physical shading: estimates one part of the light of each path. */
    public PathIntegrator(CompiledScene scene, RayCounters counters, PathPart part) {
        this(scene, counters, part, scene.physical.hasCausticPass());
    }

    /** If hasCausticPass, leaves out caustics that the caustic pass samples, and samples those that it cannot in other ways. */
    public PathIntegrator(CompiledScene scene, RayCounters counters, boolean hasCausticPass) {
        this(scene, counters, PathPart.WHOLE, hasCausticPass);
    }

    /** For one thread that shares light subpaths, too, among paths that are cut, where the scene allows it ({@link #reusesLight}). */
    public static PathIntegrator reusingLight(CompiledScene scene, RayCounters counters) {
        PathIntegrator made = new PathIntegrator(scene, counters);
        made.reuse = LightVertexReuse.of(scene, counters, made.path);
        made.connections.reuse(made.reuse);
        return made;
    }

    private PathIntegrator(CompiledScene scene, RayCounters counters, PathPart part, boolean hasCausticPass) {
        super(scene, counters, new PathValue(BandMixing.of(scene.physical)), showsLamps(part));
        isAlbedo = part == PathPart.ALBEDO;
        directOnly = part == PathPart.DIRECT || part == PathPart.ALBEDO;
        value.isIndirect = part == PathPart.INDIRECT;
        path.tracer.leaveVisibilityOpen();
        nextEvent = new NextEventEstimation(scene, counters, path);
        connections = new PathConnections(path.tracer);
        if (isAlbedo) {
            value.wavelength = null;
        }
        causticPass = hasCausticPass ? new CausticPassShare(physical.caustics) : null;
        walk = RandomWalk.of(scene, counters, path, value, part);
        mirrorCaustics = hasCausticPass && !directOnly ? MirrorCaustics.of(scene, counters, path) : null;
        emission = new PathEmission(path, value, state, nextEvent, images, causticPass, mirrorCaustics);
    }

    private static boolean showsLamps(PathPart part) {
        return part == PathPart.WHOLE || part == PathPart.DIRECT;
    }

    @Override
    public void stopWhen(BooleanSupplier condition) {
        super.stopWhen(condition);
        if (reuse != null) {
            reuse.stopWhen(condition);
        }
    }

    @Override
    public void shade(Ray ray, Sampler sampler, double[] out) {
        follow(ray, sampler);
        value.get(out);
    }

    /** Follows a path up to its first random decision; {@link #certain} is then the same as after {@link #shade}. Overwrites the ray. */
    public void glimpse(Ray ray, Sampler sampler) {
        begin(ray, sampler);
        while (step(ray, sampler) && value.certain) {}
    }

    /**
     * The deterministic part of the last path's radiance, a function of the film position alone: emission seen directly or in mirrors, and
     * at the first matte surface the closed forms of lamps that nothing can occlude there, and of point lights.
     *
     * @param out receives the radiance: red, green and blue, linear
     * @return a 64-bit hash of the surfaces that were hit, and of which lamps are hidden, fully visible or undecided there
     */
    public long certain(double[] out) {
        return value.certain(out, path.key);
    }

    /** As {@link #shade(Ray, Sampler, double[])}, but cuts the path at its second vertex if it can, for {@link #connections}. */
    public void shade(Ray ray, Sampler sampler, PathCut out) {
        cut = out;
        cut.clear();
        if (reuse != null) {
            reuse.begin(sampler, cut);
        }
        follow(ray, sampler);
        value.get(cut.gives ? cut.given : cut.own);
        cut = null;
    }

    /** Whether light subpaths are shared among paths that are cut. */
    public boolean reusesLight() {
        return reuse != null;
    }

    /** Connects this thread's paths that were cut. */
    public PathConnections connections() {
        return connections;
    }

    /** The number of scattering events after which the last path continued. */
    public int events() {
        return followed;
    }

    private void begin(Ray ray, Sampler sampler) {
        if (mirrorCaustics != null) {
            mirrorCaustics.begin();
        }
        beginPath(ray, sampler);
    }

    private void follow(Ray ray, Sampler sampler) {
        begin(ray, sampler);
        images.gather(sampler, value);
        do {
            followed = state.events;
        } while (step(ray, sampler));
    }

    /** Processes one vertex: finds it, adds emission and direct light, samples the next direction; returns whether the path goes on. */
    private boolean step(Ray ray, Sampler sampler) {
        value.disperse();
        SurfaceMaterial medium = physical.hasAbsorption ? path.medium() : null;
        PathFollower.Event event = walk == null ? path.next(ray) : walk.next(ray, medium, state, sampler);
        if (event == null) {
            return mayScatter() && walk.scatter(ray, nextEvent, vertex, state, sampler) && path.continues();
        }
        if (event == PathFollower.Event.NOTHING) {
            if (!isAlbedo) {
                emission.escape(ray);
            }
            return false;
        }
        if (medium != null && medium.absorbs && medium.medium == null) {
            value.absorb(medium, path.distance(ray));
        }
        return event == PathFollower.Event.SURFACE ? surface(ray, sampler) : glass(ray, sampler);
    }

    /** Shades an opaque surface; returns whether the path goes on. */
    private boolean surface(Ray ray, Sampler sampler) {
        SurfaceMaterial material = path.at.material;
        if (material.glows && !isAlbedo) {
            emission.add(ray, cut);
        }
        if (material.isBlack || !mayScatter()) {
            return false;
        }
        if (cut != null && reuse != null && reuse.follow(ray, cut, state, value, sampler)) {
            return false;
        }
        path.color(material, surface);
        if (isAlbedo && !material.isDelta) {
            Albedo.find(path, ray, material, physical.hasUltraviolet, surface);
            return value.endsWith(surface);
        }
        if (material.isDelta) {
            return reflect(ray, material, sampler);
        }
        return path.at.bsdf == Lambert.INSTANCE
                ? matte(ray, material.reradiation, sampler)
                : rough(ray, path.at.bsdf, material.reradiation, sampler);
    }

    /** Reflects the path at a mirror; returns whether it goes on. */
    private boolean reflect(Ray ray, SurfaceMaterial material, Sampler sampler) {
        int mirror = path.at.id;
        if (!path.scatter(ray, material, surface, 0, 0, 0)) {
            return false;
        }
        state.extendSpecular(mirror);
        return survives(surface[0], surface[1], surface[2], sampler) && path.continues();
    }

    /** Shades a Lambertian surface, where direct light has closed forms; dye is that of a fluorescent surface, else null. */
    private boolean matte(Ray ray, Reradiation dye, Sampler sampler) {
        if (cut != null && path.surfaces < 2) {
            cut.note(path, surface, value, dye != null);
            if (reuse != null && cut.gives) {
                cut.endOpen(ray, state);
                return false;
            }
        }
        connectFirst(ray);
        if (dye != null && !value.scatter(dye, surface)) {
            return false;
        }
        Scattering arrived = mirrorCaustics == null ? null : path.arrive(ray, surface);
        vertex.set(Lambert.INSTANCE, arrived, surface, PathEvent.WIDE, false);
        nextEvent.direct(vertex, state, sampler, value);
        if (value.certain) {
            value.leaveToChance(path.key + nextEvent.gathered.views);
        }
        if (mirrorCaustics != null) {
            mirrorCaustics.direct(vertex, state, sampler, value);
        }
        sampler.pair(state.address++, Sampler.Purpose.DIRECTION, pair);
        Scattering s = path.scatterMatte(ray, pair[0], pair[1]);
        state.extend(PathEvent.WIDE, s, false);
        return s.pdf > 0 && survives(surface[0], surface[1], surface[2], sampler) && path.continues();
    }

    /** Shades a surface with any other BSDF; dye is that of a fluorescent surface (with vertex normals, say), else null. */
    private boolean rough(Ray ray, Bsdf bsdf, Reradiation dye, Sampler sampler) {
        if (dye != null && !value.scatter(dye, surface)) {
            return false;
        }
        value.leaveToChance(path.key);
        Scattering s = path.arrive(ray, surface);
        boolean isNarrow = causticPass != null && causticPass.isNarrow(bsdf);
        // Path reuse skips narrow lobes: they gather light of other narrow lobes, which the caustic pass samples at
        // wide vertices.
        if (!isNarrow
                && !bsdf.hasDelta()
                && !path.at.isSmooth()
                && cut != null
                && path.surfaces < 2
                && cut.noteRough(path, bsdf, s, value, reuse != null || physical.hasConstantEnvironment())) {
            return leaveCut(ray, bsdf, s, sampler);
        }
        if (!isNarrow) {
            connectFirst(ray);
        }
        PathEvent event = isNarrow ? PathEvent.NARROW : PathEvent.WIDE;
        boolean leaves = isNarrow && state.isNarrowSampledByCausticPass();
        vertex.set(bsdf, s, surface, event, leaves);
        nextEvent.direct(vertex, state, sampler, value);
        if (mirrorCaustics != null) {
            mirrorCaustics.direct(vertex, state, sampler, value);
        }
        if (!sample(bsdf, s, sampler)) {
            return false;
        }
        path.leave(ray, s);
        if (s.delta && !isNarrow) {
            state.extendSpecular(-1);
        } else {
            state.extend(event, s, leaves);
        }
        return survives(s.valueR, s.valueG, s.valueB, sampler) && path.continues();
    }

    /** Connects the path's first vertex to its light subpath, where these are shared. */
    private void connectFirst(Ray ray) {
        if (cut != null && reuse != null && path.surfaces == 0) {
            reuse.connectFirst(ray, cut, state, value);
        }
    }

    /** Samples the direction in which the path leaves an opaque surface; returns whether there is one. */
    private boolean sample(Bsdf bsdf, Scattering s, Sampler sampler) {
        sampler.pair(state.address, Sampler.Purpose.DIRECTION, pair);
        double choice = sampler.unit(state.address++, Sampler.Purpose.CHOICE);
        return bsdf.sample(s, pair[0], pair[1], choice);
    }

    /** Scatters the path at an interface of glass, or at a thin slab; returns whether it goes on. */
    private boolean glass(Ray ray, Sampler sampler) {
        value.leaveToChance(path.key);
        sampler.pair(state.address, Sampler.Purpose.CHOICE, pair);
        double choice = pair[0];
        int opaque = physical.hasPartialGlass ? path.glass.opaque(pair[1]) : -1;
        if (opaque >= 0) {
            path.turnToOpaque(opaque);
            return surface(ray, sampler);
        }
        boolean isRough = false;
        if (physical.hasRoughGlass) {
            isRough = directAtInterface(ray, sampler);
            sampler.pair(state.address, Sampler.Purpose.DIRECTION, pair);
        }
        state.address++;
        cross(ray, choice);
        if (path.glass.passedStraight()) {
            // Passing straight is no event: an object may be cut into any number of pieces. Shadow rays pass, too: MIS
            // keeps the last
            // vertex.
            value.filter(surface[0], surface[1], surface[2]);
            return path.continues();
        }
        if (!goesFurther()) {
            return false;
        }
        if (isRough) {
            state.extendAtRoughGlass(path.glass.atInterface, vertex.leavesSmallLights, path.glass.hasNext());
        } else {
            state.extendSpecular(-1);
        }
        boolean survives = walk == null
                ? survives(surface[0], surface[1], surface[2], sampler)
                : walk.survives(surface, sampler, state);
        return survives && path.continues();
    }

    /** Adds direct light if the path is at a rough interface; returns whether it is. */
    private boolean directAtInterface(Ray ray, Sampler sampler) {
        Bsdf bsdf = path.mayScatter() ? path.roughInterface(ray, atInterface) : null;
        if (bsdf == null || !goesFurther()) {
            return false;
        }
        Arrays.fill(surface, 1);
        path.filter(surface);
        path.turnTo(0);
        boolean isNarrow = causticPass != null && causticPass.isNarrow(bsdf);
        boolean leaves = isNarrow && state.isNarrowSampledByCausticPass();
        vertex.set(bsdf, atInterface, surface, PathEvent.ROUGH_INTERFACE, leaves);
        nextEvent.direct(vertex, state, sampler, value);
        return true;
    }

    /** Whether the path may have one more scattering event. */
    private boolean mayScatter() {
        return path.mayScatter() && goesFurther();
    }

    /** Called at an event: returns whether the path may continue after it; light found from the next event on is indirect. */
    private boolean goesFurther() {
        if (state.hasScattered()) {
            value.beginIndirect();
        }
        return !(directOnly && state.hasScattered());
    }

    /** Multiplies the throughput by the weight of the last event, and plays Russian roulette where that is due. */
    private boolean survives(double r, double g, double b, Sampler sampler) {
        value.filter(r, g, b);
        if (value.isSafe(state) || cut != null && cut.takes && path.surfaces == 0) {
            return true;
        }
        value.leaveToChance(path.key);
        return value.survives(r, g, b, sampler, state);
    }

    /**
     * Leaves the rough vertex at which the path is cut: incident radiance is stored there, and the paths that share it shade it. Where light
     * subpaths are shared, the path ends there for now.
     */
    private boolean leaveCut(Ray ray, Bsdf bsdf, Scattering s, Sampler sampler) {
        if (reuse != null) {
            cut.endOpen(ray, state);
            return false;
        }
        nextEvent.sample(sampler, state.address, cut.lamp);
        if (!sample(bsdf, s, sampler)) {
            return false;
        }
        cut.leave(s);
        path.leave(ray, s);
        state.extend(PathEvent.WIDE, s, false);
        return path.continues();
    }
}
