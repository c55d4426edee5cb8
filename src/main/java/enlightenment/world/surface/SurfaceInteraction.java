package enlightenment.world.surface;

import enlightenment.bsdf.Bsdf;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.world.CompiledScene;
import enlightenment.world.material.SurfaceDetail;
import enlightenment.world.material.SurfaceMaterial;

/**
 * The vertex of a path on a surface or in a medium, as light transport reads it. All fields but {@link #hit} are set by {@link #arrive},
 * the one place where hits become interactions. A mutable work object, one per path.
 */
public final class SurfaceInteraction {
    private static final int NOWHERE = -1;

    private static final int NO_LIGHT = -1;

    /** Point, geometric normal (it points to the outside), side and face. Rays that leave the surface start there. */
    public final Hit hit = new Hit();

    /** The primitive's id; -1 in a medium. */
    public int id = NOWHERE;

    /** The material of the face; null in a medium. */
    public SurfaceMaterial material;

    /** Whether a texture has changed the hit's shading normal. */
    private boolean isTurned;

    private final double[] scratch = new double[3];

    /** The scattering function of the face; null in a medium. */
    public Bsdf bsdf;

    /** The index of the face's light; -1 if it emits nothing, or nothing that can be sampled. */
    public int light = NO_LIGHT;

    /** The unit shading normal on the side that the path came from; (0, 0, 0) in a medium. */
    public double nx;

    public double ny;
    public double nz;

    /** The radiance that this point of the surface emits, linear, by band; set by {@link #findEmission}. */
    public double emittedR;

    public double emittedG;
    public double emittedB;
    public double emittedUltraviolet;

    /**
     * Completes the interaction once {@link #hit} is set.
     *
     * @param atId id of the primitive
     */
    public void arrive(CompiledScene scene, int atId) {
        id = atId;
        find(scene.material(atId, hit.face));
        light = material.glows && scene.physical != null ? scene.physical.lightOf(atId, hit.face) : NO_LIGHT;
    }

    /** Makes the material that of partly transparent glass where it is opaque. */
    public void becomeOpaque() {
        find(material.opaque);
    }

    /** Sets the material, with the scattering function and shading normal at the hit. */
    private void find(SurfaceMaterial of) {
        material = of;
        isTurned = false;
        while (material.detail != null) {
            resolve(material.detail);
        }
        bsdf = material.bsdf;
        if (material.smooth != null && (isTurned || hit.primitive.shadingNormal(hit))) {
            bsdf = material.smooth;
            nx = hit.sx * hit.side;
            ny = hit.sy * hit.side;
            nz = hit.sz * hit.side;
            return;
        }
        nx = hit.nx * hit.side;
        ny = hit.ny * hit.side;
        nz = hit.nz * hit.side;
    }

    /** Resolves a material's detail at the hit. */
    private void resolve(SurfaceDetail detail) {
        if (detail.turnsNormal()) {
            if (!isTurned && !hit.primitive.shadingNormal(hit)) {
                hit.shadeByOwnNormal();
            }
            isTurned = true;
            detail.turn(hit, scratch);
        }
        material = detail.at(hit, scratch);
    }

    /** Whether a surface of this material has a hole at the hit. */
    public boolean isHole(SurfaceMaterial of) {
        SurfaceMaterial m = of;
        while (m.detail != null) {
            if (m.detail.isMask() && m.detail.isHole(hit, scratch)) {
                return true;
            }
            m = m.detail.at(hit, scratch);
        }
        return false;
    }

    /** Sets the interaction to a point of a medium. */
    public void arriveInMedium(double x, double y, double z) {
        hit.px = x;
        hit.py = y;
        hit.pz = z;
        hit.nx = 0;
        hit.ny = 0;
        hit.nz = 0;
        hit.side = Ray.OUTSIDE;
        hit.primitive = null;
        id = NOWHERE;
        material = null;
        bsdf = null;
        light = NO_LIGHT;
        nx = 0;
        ny = 0;
        nz = 0;
    }

    /** Whether the shading normal differs from the geometric normal. */
    public boolean isSmooth() {
        return bsdf != material.bsdf;
    }

    /** Sets the emitted radiance to that of this point, on the sides that glow. */
    public void findEmission() {
        emittedR = material.glowR;
        emittedG = material.glowG;
        emittedB = material.glowB;
        emittedUltraviolet = material.glowUltraviolet;
        if (material.radianceMap != null) {
            material.radianceMap.factor(hit, scratch);
            emittedR *= scratch[0];
            emittedG *= scratch[1];
            emittedB *= scratch[2];
            emittedUltraviolet *= scratch[2];
        }
    }

    /** Whether the surface emits light towards the path's previous vertex. */
    public boolean emits() {
        return material.glows && material.glowsTo(hit.side);
    }
}
