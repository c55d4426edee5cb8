package enlightenment.physical;

import enlightenment.material.Glass;
import enlightenment.math.Vec3;

/** Lights without extent, which no path meets: what comes from them straight, through panes, or reflected by one. */
final class NaivePoints {
    private final NaiveScene scene;

    NaivePoints(NaiveScene scene) {
        this.scene = scene;
    }

    /**
     * Adds what a surface reflects of their light.
     *
     * @param axes of the surface, the normal last
     * @param out where to, by these axes
     * @param withImages whether the light may be reflected by panes before
     */
    void add(Vec3 at, Vec3[] axes, NaiveReflector reflector, Vec3 out, boolean withImages, double[] sum) {
        for (NaiveScene.Point p : scene.points) {
            Vec3 way = p.position().minus(at);
            Vec3 in = NaiveTracer.local(axes, way.normalized());
            if (in.z() > 0) {
                double[] kept = visibility(at, way.normalized(), way.length());
                addFrom(p, kept, way, reflector, out, in, sum);
            }
            if (withImages) {
                addImages(p, at, axes, reflector, out, sum);
            }
        }
    }

    private static void addFrom(
            NaiveScene.Point light,
            double[] kept,
            Vec3 way,
            NaiveReflector reflector,
            Vec3 out,
            Vec3 in,
            double[] sum) {
        for (int band = 0; band < 3; band++) {
            sum[band] += kept[band] * light.intensity()[band] * reflector.value(band, out, in) * in.z() / way.dot(way);
        }
    }

    /** Adds a point light as panes reflect it: once, by one of them. */
    private void addImages(
            NaiveScene.Point light, Vec3 at, Vec3[] axes, NaiveReflector reflector, Vec3 out, double[] sum) {
        for (NaiveScene.Surface pane : scene.surfaces) {
            if (!pane.isGlass() || !(pane.shape() instanceof NaiveShape.Flat flat)) {
                continue;
            }
            Vec3 way = flat.mirrored(light.position()).minus(at);
            Vec3 d = way.normalized();
            Vec3 in = NaiveTracer.local(axes, d);
            double before = flat.hit(at, d, 0);
            if (!(in.z() > 0) || !(before < way.length())) {
                continue;
            }
            Vec3 met = at.plus(d.times(before));
            Vec3 rest = light.position().minus(met);
            double index = ((Glass) pane.material()).indexOfRefraction();
            double around = NaiveScene.index(scene.medium(at.plus(d.times(before / 2))));
            double share = NaiveFresnel.pane(Math.abs(d.dot(flat.normal(met))), around, index);
            double[] kept = NaiveColors.product(
                    visibility(at, d, before * (1 - 1e-9)), visibility(met, rest.normalized(), rest.length()));
            addFrom(light, NaiveTracer.scaled(kept, share), way, reflector, out, in, sum);
        }
    }

    /** What a point light's light keeps on its straight way: all, or what panes let through, or nothing. */
    double[] visibility(Vec3 from, Vec3 d, double length) {
        double[] left = {1, 1, 1};
        Vec3 o = from;
        double rest = length;
        while (true) {
            NaiveScene.Hit hit = scene.nearest(o, d);
            double way = hit == null ? rest : Math.min(rest, hit.distance());
            left = NaiveColors.product(
                    left, scene.fills(o.plus(d.times(way / 2))).transmittance(way));
            if (hit == null || hit.distance() >= rest) {
                return left;
            }
            if (!hit.surface().isGlass()) {
                return new double[3];
            }
            if (hit.surface().isSolid()) {
                NaiveScene.Surface before = scene.medium(hit, 1);
                NaiveScene.Surface after = scene.medium(hit, -1);
                if (NaiveScene.index(before) != NaiveScene.index(after)) {
                    return new double[3];
                }
                left = before == after ? left : NaiveColors.product(left, NaiveTracer.color(hit));
            } else {
                double around = NaiveScene.index(scene.medium(hit, 1));
                double index = ((Glass) hit.surface().material()).indexOfRefraction();
                left = NaiveColors.product(
                        left,
                        NaiveTracer.scaled(
                                NaiveTracer.color(hit), 1 - NaiveFresnel.pane(-d.dot(hit.normal()), around, index)));
            }
            o = hit.point();
            rest -= hit.distance();
        }
    }
}
