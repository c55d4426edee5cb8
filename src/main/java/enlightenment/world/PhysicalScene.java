package enlightenment.world;

import enlightenment.accel.Accelerator;
import enlightenment.accel.PrimitiveList;
import enlightenment.color.Rgb;
import enlightenment.emitter.LightSampler;
import enlightenment.frame.Bounds;
import enlightenment.frame.SceneFrame;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Primitive;
import enlightenment.scene.Shading;
import enlightenment.surroundings.Sun;
import enlightenment.surroundings.Surroundings;
import enlightenment.world.contact.CoincidentSurfaces;
import enlightenment.world.contact.StraightGlass;
import enlightenment.world.contact.TouchedBoxes;
import enlightenment.world.light.CausticPass;
import enlightenment.world.light.LightBands;
import enlightenment.world.light.LightMedia;
import enlightenment.world.light.LightPyramid;
import enlightenment.world.light.OccluderSet;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.material.MaterialBsdfs;
import enlightenment.world.material.PhysicalSurface;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.CancellationCheck;
import enlightenment.world.parts.CompiledPrimitives;
import enlightenment.world.parts.SceneExtent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The part of a compiled scene that only physical shading has: lights, surroundings, and the features that the scene requires. Immutable.
 */
public final class PhysicalScene {
    /**
     * Binary logarithm of the least {@link #areaUnit}: that of the largest scenes for which correctness is promised
     * (docs/notes/numerics.md).
     */
    private static final int LEAST_AREA = -400;

    private static final int NO_LIGHT = -1;

    /** The lights: emitting faces of primitives in the order of ids and faces, then point lights. */
    public final PhysicalLight[] lights;

    /** Samples one of the lights, by their indices. */
    public final LightSampler picker;

    /** The constant radiance of the surroundings: linear, by band. */
    public final double backgroundR;

    public final double backgroundG;
    public final double backgroundB;

    /** Surroundings whose radiance varies with direction, all of it: then {@link #backgroundR} and its like are 0; else null. */
    public final Surroundings surroundings;

    /** The largest number of scattering events of a path. */
    public final int maxBounces;

    /** The targets of light paths for caustics; null if there is no caustic pass. */
    public final CausticPass caustics;

    /** The ambient medium: the material that fills the scene outside of its solids, without bound; null if empty space does. */
    public final SurfaceMaterial around;

    /** Whether a medium scatters light, or there is an ambient medium. */
    public final boolean hasScattering;

    /** Whether a point of a light may lie inside of a solid that is a medium. */
    public final boolean lightsLieInGlass;

    /** Whether a medium attenuates light. */
    public final boolean hasAbsorption;

    /** Whether interfaces of media may be rough. */
    public final boolean hasRoughGlass;

    /** Whether indices of refraction depend on the wavelength. */
    public final boolean hasDispersion;

    /** Whether some glass is partly opaque. */
    public final boolean hasPartialGlass;

    /**
     * Whether shadow rays may pass glass that keeps their direction: thin slabs, interfaces of media of equal index, and faces of solids
     * inside a solid of higher priority.
     */
    public final boolean hasStraightGlass;

    /** Whether some surface has an alpha mask. */
    public final boolean hasMasks;

    /** Whether the scene has ultraviolet light, and a fluorescent surface that absorbs it. */
    public final boolean hasUltraviolet;

    /** The largest share of ultraviolet that a surface re-emits in a visible band; 0 if there is none. */
    public final double visibleOfUltraviolet;

    /** By band, roughly the amount of light in the scene, relative; null unless there are fluorescent surfaces. */
    public final double[] lightOfBands;

    /** Whether objects may be seen in mirrors, in thin slabs, or through glass that refracts. */
    public final boolean showsMirrored;

    /**
     * The unit of areas in MIS weights, a power of two in areas of the frame: squares of areas must stay within the range of doubles. It is
     * the geometric mean of the area of the scene, about 1, and of the smallest object that rounding in the frame leaves larger
     * than a point.
     */
    public final double areaUnit;

    /** By id: the index in {@link #lightOfFace} of its first face; -1 if none of its faces emits. */
    private final int[] firstFace;

    private final int[] lightOfFace;

    PhysicalScene(
            Shading.Physical shading,
            SceneFrame frame,
            Surroundings surroundings,
            CompiledPrimitives compiled,
            Accelerator accelerator,
            List<PhysicalLight> points,
            Bounds eye,
            Runnable poll) {
        around = shading.medium().map(m -> around(m, frame)).orElse(null);
        Rgb clear = seen(Rgb.WHITE, around);
        this.surroundings = surroundings == null || around == null || clear.equals(Rgb.WHITE)
                ? surroundings
                : clear.max() > 0 ? surroundings.filtered(clear) : null;
        Rgb background =
                seen(shading.background() instanceof Shading.Background.Constant c ? c.radiance() : Rgb.BLACK, around);
        boolean isConstant = this.surroundings == null;
        backgroundR = isConstant ? background.r() : 0;
        backgroundG = isConstant ? background.g() : 0;
        backgroundB = isConstant ? background.b() : 0;
        maxBounces = shading.maxBounces().orElse(Integer.MAX_VALUE);
        boolean fluoresces = compiled.materials().any(m -> m.reradiation != null);
        hasUltraviolet = fluoresces && LightBands.haveUltraviolet(compiled.materials(), points);
        visibleOfUltraviolet = hasUltraviolet ? LightBands.visibleOfUltraviolet(compiled.materials()) : 0;
        int least = Scale.exponent(SceneExtent.least(compiled.primitives()));
        areaUnit = Math.scalb(1.0, Math.max(least, LEAST_AREA));
        int n = compiled.primitives().length;
        firstFace = new int[n];
        List<Integer> ofFaces = new ArrayList<>();
        List<PhysicalLight> all = new ArrayList<>();
        for (int id = 0; id < n; id++) {
            firstFace[id] = NO_LIGHT;
            int faces = compiled.primitives()[id].faceCount();
            int first = ofFaces.size();
            for (int face = 0; face < faces; face++) {
                PhysicalLight light = lightOf(compiled, id, face, eye);
                ofFaces.add(light == null ? NO_LIGHT : all.size());
                if (light != null) {
                    firstFace[id] = first;
                    all.add(light);
                }
            }
            if (firstFace[id] == NO_LIGHT) {
                ofFaces.subList(first, ofFaces.size()).clear();
            }
        }
        for (PhysicalLight point : points) {
            PhysicalLight shown = hasUltraviolet ? point : point.withoutUltraviolet();
            if (brightness(shown) > 0) {
                all.add(shown);
            }
        }
        hasRoughGlass = compiled.materials().any(m -> m.isGlass && !m.isDelta);
        hasDispersion = Arrays.stream(compiled.glassSolids())
                .anyMatch(id -> compiled.materials().inside(id).dispersion != 0);
        hasPartialGlass = compiled.materials().any(m -> m.isGlass && m.transparency < 1);
        hasScattering = around != null || compiled.materials().any(m -> m.medium != null);
        hasAbsorption = around != null
                || Arrays.stream(compiled.glassSolids())
                        .anyMatch(id -> compiled.materials().inside(id).absorbs);
        hasMasks = compiled.materials().haveMasks();
        hasStraightGlass = hasMasks || StraightGlass.mayBeThere(compiled, accelerator, poll);
        showsMirrored = compiled.materials().any(m -> !m.isGlass && m.bsdf.hasDelta() && !m.isBlack)
                || hasClearGlass(compiled)
                || StraightGlass.hasPanes(compiled);
        lights = all.toArray(new PhysicalLight[0]);
        lightOfFace = ofFaces.stream().mapToInt(i -> i).toArray();
        LightMedia.find(lights, compiled, accelerator, poll);
        lightsLieInGlass = hasScattering && Arrays.stream(lights).anyMatch(l -> l.mediaAround().length > 0);
        Sun[] suns = isConstant ? new Sun[0] : this.surroundings.suns.toArray(new Sun[0]);
        caustics = CausticPass.of(lights, suns, visibleOfUltraviolet, compiled, maxBounces);
        picker = picker(lights, poll);
        lightOfBands = fluoresces ? LightBands.typical(lights, background) : null;
    }

    /** The surroundings' radiance behind an unbounded ambient medium: 0 in every band that the medium attenuates. */
    private static Rgb seen(Rgb background, SurfaceMaterial around) {
        if (around == null) {
            return background;
        }
        double[] left = {background.r(), background.g(), background.b()};
        around.absorb(Double.MAX_VALUE, left);
        return new Rgb(left[0], left[1], left[2]);
    }

    private static SurfaceMaterial around(Medium medium, SceneFrame frame) {
        Material material = Material.Scattering.of(medium);
        return new SurfaceMaterial(material, null, PhysicalSurface.of(material, frame, null, new MaterialBsdfs()));
    }

    /** The brightness by which a light is sampled: its luminance plus the visible effect of its ultraviolet. */
    private double brightness(PhysicalLight light) {
        return hasUltraviolet ? light.luminance() + visibleOfUltraviolet * light.meanUltraviolet : light.luminance();
    }

    private LightSampler picker(PhysicalLight[] lights, Runnable poll) {
        LightSampler.Builder builder = new LightSampler.Builder();
        for (PhysicalLight light : lights) {
            if (light.isPoint) {
                builder.addPoint(new Vec3(light.x, light.y, light.z), light.profile, brightness(light));
            } else {
                builder.add(light.form, brightness(light));
            }
        }
        return builder.build(poll);
    }

    private PhysicalLight lightOf(CompiledPrimitives compiled, int id, int face, Bounds eye) {
        SurfaceMaterial m = compiled.materials().of(id, face);
        if (!m.glows || !hasUltraviolet && !m.glowsVisibly()) {
            return null;
        }
        double ultraviolet = hasUltraviolet ? m.glowUltraviolet : 0;
        Primitive p = compiled.primitives()[id];
        // No path enters or leaves an opaque solid.
        boolean isInsideSeen = !p.isSolid() || compiled.materials().inside(id).isGlass || eye.overlaps(p.bounds());
        PhysicalLight light =
                PhysicalLight.glowing(p, id, face, m.glow(), ultraviolet, m.sides, isInsideSeen, m.radianceMap);
        // A face whose texture is black does not emit.
        return light == null || m.radianceMap != null && !(brightness(light) > 0) ? null : light;
    }

    /** Whether a solid of smooth glass refracts. */
    private static boolean hasClearGlass(CompiledPrimitives compiled) {
        return Arrays.stream(compiled.glassSolids())
                .mapToObj(id -> compiled.materials().inside(id))
                .anyMatch(m -> m.indexOfRefraction != 1 && m.any(part -> part.isDelta));
    }

    /**
     * Finds for each light the primitives that may occlude it from a point of a surface. With an ambient medium, any point may scatter
     * light, behind the walls of a room as well.
     */
    void findOccluders(Primitive[] primitives, OccluderSet set, PrimitiveList all) {
        for (PhysicalLight light : lights) {
            PrimitiveList some = all.empty();
            int n = 0;
            for (int id = 0; id < primitives.length; id++) {
                boolean mayOcclude = around != null || set.mayOcclude(id, light, primitives);
                if (mayOcclude && !(id == light.id && light.hidesNothingOfItself)) {
                    some.members()[n++] = id;
                }
            }
            some.size(n);
            light.occluders = some;
            light.pyramid = LightPyramid.of(light, primitives);
        }
    }

    /** Finds for each light the faces that it lies on. */
    void lieOn(
            CompiledPrimitives compiled, TouchedBoxes near, CoincidentSurfaces coincident, boolean few, Runnable poll) {
        for (int i = 0; i < lights.length; i++) {
            if (CancellationCheck.isDue(i)) {
                poll.run();
            }
            lights[i].lieOn(compiled, near, coincident, few);
        }
    }

    /** The index of the light of a primitive's face; -1 if it is none. */
    public int lightOf(int id, int face) {
        int first = firstFace[id];
        return first < 0 ? NO_LIGHT : lightOfFace[first + face];
    }

    /** Whether the surroundings' radiance is the same for all rays that leave the scene. */
    public boolean hasConstantEnvironment() {
        return around == null && surroundings == null;
    }

    /** Whether there is a caustic pass, whose light paths from the eye leave out. */
    public boolean hasCausticPass() {
        return caustics != null;
    }
}
