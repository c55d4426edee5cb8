package enlightenment.world.surface;

import enlightenment.bsdf.Bsdf;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.world.CompiledScene;
import enlightenment.world.material.SurfaceDetail;
import enlightenment.world.material.SurfaceMaterial;

/**
 * A surface where a path is: what a ray has met, as light transport sees it. All of it but the {@link #hit} is set by {@link #arrive}, the one
 * place where hits become interactions. A mutable work object, one per path.
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

    /** Whether the hit's shading normal has been turned by a texture. */
    private boolean isTurned;

    private final double[] scratch = new double[3];

    /** How the face scatters light; null in a medium. */
    public Bsdf bsdf;

    /** The index of the light that the face is; -1 if it emits nothing, or nothing that could be sampled. */
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

    /** Completes the interaction once its hit is set. */
    public void arrive(CompiledScene scene, int atId) {
        id = atId;
        find(scene.material(atId, hit.face));
        light = material.glows && scene.physical != null ? scene.physical.lightOf(atId, hit.face) : NO_LIGHT;
    }

    /** Where glass is opaque, as chance has it: the surface is made of that. */
    public void becomeOpaque() {
        find(material.opaque);
    }

    /** Finds how a surface of this material scatters light here. */
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

    /** Finds what is there of a material with detail. */
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

    /** Whether the surface, of this material, has a hole there: there is nothing then. */
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

    /** Places it at a point of a medium. */
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

    /** Whether the shading normal is not that of the surface itself. */
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

    /** Whether the surface emits light towards where the path came from. */
    public boolean emits() {
        return material.glows && material.glowsTo(hit.side);
    }
}
