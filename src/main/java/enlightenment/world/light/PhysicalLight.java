package enlightenment.world.light;

import enlightenment.color.Rgb;
import enlightenment.emitter.AreaLight;
import enlightenment.emitter.AreaLights;
import enlightenment.emitter.IntensityProfile;
import enlightenment.emitter.LightSides;
import enlightenment.emitter.SphereLight;
import enlightenment.material.Material;
import enlightenment.math.Vec3;
import enlightenment.primitive.EndFaces;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.primitive.RectanglePrimitive;
import enlightenment.primitive.SupportSurface;
import enlightenment.world.contact.CoincidentSurfaces;
import enlightenment.world.contact.TouchedBoxes;
import enlightenment.world.material.RadianceMap;
import enlightenment.world.parts.CompiledPrimitives;

/**
 * A light of physical shading: an emitting face of a primitive, or a point. An emitter is a surface like any other: rays hit it, and it
 * occludes what is behind it.
 */
public final class PhysicalLight extends LightBody {
    private static final int NO_PRIMITIVE = -1;

    private static final int[] NO_MEDIA = {};

    /** The light's form, which samples points on it; null for a point light. */
    public final AreaLight form;

    /** The id of the emitting primitive; -1 for a point light. */
    public final int id;

    /** The emitting face of the primitive. */
    public final int face;

    /**
     * Whether it is a point light, sampled as a delta light: then {@link #r}, {@link #g}, {@link #b} are radiant intensity in units of the
     * frame.
     */
    public final boolean isPoint;

    /**
     * The dependence of a point light's intensity on direction; null if it is the same in all directions, and for lights with a surface.
     */
    public final IntensityProfile profile;

    /** Whether it is a ball: then direct light of matte surfaces always has a closed form. */
    public final boolean isBall;

    /** Whether it is flat: then it gives no light to points in its plane. */
    public final boolean isFlat;

    /** The factor of radiance at each point of the surface; null if it is constant, and for point lights. */
    public final LightTexture texture;

    /**
     * Emitted radiance (W/(m² sr), relative), the same in all directions on the sides that shine and, but for a {@link #texture}, at all points; of a point light the
     * radiant intensity (the largest one, if it has a {@link #profile}), scaled so that intensity over squared distance in the frame is irradiance in the scene's units. Linear, by band.
     */
    public final double r;

    public final double g;
    public final double b;

    /** Emitted radiance or intensity of ultraviolet; 0 if nothing in the scene shows it. */
    public final double ultraviolet;

    /**
     * The mean of {@link #r}, {@link #g}, {@link #b} and {@link #ultraviolet} over the surface, for sampling of lights. Greater than 0 in
     * each band in which any point emits.
     */
    public final double meanR;

    public final double meanG;
    public final double meanB;
    public final double meanUltraviolet;

    /** Whether the outside of the surface emits. */
    public final boolean shinesOutside;

    /** Whether the inside of the surface emits light that may be seen. */
    public final boolean shinesInside;

    /** Whether no segment to a point that {@link AreaLight#sample} chooses crosses the light's own primitive before its end. */
    public final boolean hidesNothingOfItself;

    /** Set once, when the scene is compiled; see {@link #mediaAround}. */
    int[] media = NO_MEDIA;

    private PhysicalLight(
            Place place,
            AreaLight form,
            IntensityProfile profile,
            Primitive surface,
            int id,
            int face,
            Rgb glow,
            double ultraviolet,
            boolean shinesOutside,
            boolean shinesInside,
            LightTexture texture) {
        super(place.at, place.radius, place.right, place.up, place.ball, place.ballRadius, surface);
        this.form = form;
        this.profile = profile;
        this.id = id;
        this.face = face;
        isPoint = surface == null;
        isBall = form instanceof SphereLight;
        isFlat = surface != null && surface.support(face).isFlat();
        r = glow.r();
        g = glow.g();
        b = glow.b();
        this.ultraviolet = ultraviolet;
        this.texture = texture;
        Rgb mean = texture == null ? Rgb.WHITE : texture.mean(form);
        meanR = r * mean.r();
        meanG = g * mean.g();
        meanB = b * mean.b();
        meanUltraviolet = ultraviolet * mean.b();
        this.shinesOutside = shinesOutside;
        this.shinesInside = shinesInside;
        hidesNothingOfItself = surface != null && (surface.isFlat() || surface.isConvex() && surface.isSolid());
    }

    /** The geometry of a light as the constructor of {@link LightBody} takes it. */
    private record Place(Vec3 at, double radius, Vec3 right, Vec3 up, Vec3 ball, double ballRadius) {
        static Place ball(Vec3 center, double radius) {
            return new Place(center, radius, Vec3.ZERO, Vec3.ZERO, center, radius);
        }

        static Place of(Primitive p, AreaLight form) {
            Vec3 ball = form.ballCenter();
            if (p instanceof RectanglePrimitive && p.support(0) instanceof SupportSurface.Plane plane) {
                Vec3[] c = plane.corners();
                return new Place(c[0], 0, c[3].minus(c[0]), c[1].minus(c[0]), ball, form.ballRadius());
            }
            return ball(ball, form.ballRadius());
        }
    }

    /**
     * Makes a point light, with intensity in squared units of length of the frame.
     *
     * @param profile factor of the intensity by direction; null if it is constant
     */
    static PhysicalLight point(Vec3 position, IntensityProfile profile, Rgb intensity, double ultraviolet) {
        return new PhysicalLight(
                Place.ball(position, 0),
                null,
                profile,
                null,
                NO_PRIMITIVE,
                0,
                intensity,
                ultraviolet,
                true,
                false,
                null);
    }

    /** This point light without ultraviolet, for scenes where nothing shows it. */
    public PhysicalLight withoutUltraviolet() {
        return ultraviolet == 0 ? this : point(new Vec3(x, y, z), profile, new Rgb(r, g, b), 0);
    }

    /**
     * Makes the light of an emitting face; null if it has no area in the frame, or emits only where it is not seen.
     *
     * @param sides the sides that emit
     * @param isInsideSeen whether paths from the eye may hit its inside
     * @param map the factor of radiance; null if it is constant
     */
    public static PhysicalLight glowing(
            Primitive p,
            int id,
            int face,
            Rgb radiance,
            double ultraviolet,
            Material.EmissionPattern.Side sides,
            boolean isInsideSeen,
            RadianceMap map) {
        AreaLight form = AreaLights.of(p, face, ofForm(sides));
        boolean shinesOutside = sides != Material.EmissionPattern.Side.BACK;
        boolean shinesInside = sides != Material.EmissionPattern.Side.FRONT && isInsideSeen;
        if (form == null || !shinesOutside && !shinesInside) {
            return null;
        }
        LightTexture texture = map == null ? null : new LightTexture(map, p, face);
        return new PhysicalLight(
                Place.of(p, form),
                form,
                null,
                p,
                id,
                face,
                radiance,
                ultraviolet,
                shinesOutside,
                shinesInside,
                texture);
    }

    private static LightSides ofForm(Material.EmissionPattern.Side sides) {
        return switch (sides) {
            case BOTH -> LightSides.BOTH;
            case FRONT -> LightSides.FRONT;
            case BACK -> LightSides.BACK;
        };
    }

    /**
     * Whether a face lies in the plane of this flat light, or of a part of it, so that no point of the face has light from it. Rounding
     * puts points of the face above or below that plane, where the light would fill half of their sky.
     */
    public boolean isInPlaneWith(int otherId, int otherFace) {
        return isFlat
                && (id == otherId && face == otherFace
                        || !lyingOn().isEmpty() && lyingOn().has(otherId, otherFace));
    }

    /**
     * Whether a primitive is the ball that this light is. From inside every direction hits it, and none is sampled; but rounding puts half
     * of the vertices on it outside, from where light of its far side would seem to come through the near one.
     */
    public boolean isBallOf(int otherId) {
        return isBall && id == otherId;
    }

    /** Luminance of the mean radiance; of a point light that of its intensity. */
    public double luminance() {
        return 0.2126 * meanR + 0.7152 * meanG + 0.0722 * meanB;
    }

    /** The ids of solids of glass that points of the light may lie in, ascending; not to be changed. */
    public int[] mediaAround() {
        return media;
    }

    /** Finds the faces that the light lies on, which do not occlude it. */
    public void lieOn(CompiledPrimitives compiled, TouchedBoxes near, CoincidentSurfaces coincident, boolean few) {
        // With few primitives, candidates for occlusion are listed for each light, without the light's own.
        int left = few && hidesNothingOfItself ? id : NO_PRIMITIVE;
        lieOn(near, face, left, new Touched() {
            @Override
            public boolean isEntered(int other, int otherFace) {
                return compiled.primitives()[other].isSolid()
                        && compiled.materials().of(other, otherFace).isGlass;
            }

            @Override
            public int covered(int other, int otherFace, boolean isTurned) {
                return compiled.materials().of(other, otherFace).isGlass
                        ? 0
                        : covered(other, otherFace, isTurned, Ray.OUTSIDE)
                                | covered(other, otherFace, isTurned, Ray.INSIDE);
            }

            private int covered(int other, int otherFace, boolean isTurned, int side) {
                int own = isTurned ? -side : side;
                boolean shines = own == Ray.OUTSIDE ? shinesOutside : shinesInside;
                return shines && coincident.precedes(other, otherFace, side, id, face, own) ? EndFaces.bit(side) : 0;
            }
        });
    }
}
