package enlightenment.emitter;

import enlightenment.frame.Bounds;

/** The bounds of some lights, as a node of a {@link LightTree} would have them, while it is built. A mutable work object. */
final class LightGroup {
    private double lowerX;
    private double lowerY;
    private double lowerZ;
    private double upperX;
    private double upperY;
    private double upperZ;
    private double strength;

    /** A cone around their normals; null if there are no lights. */
    private NormalCone normals;

    void clear() {
        normals = null;
    }

    boolean isEmpty() {
        return normals == null;
    }

    void add(LightNode n) {
        Bounds b = n.box;
        add(
                b.min().x(),
                b.min().y(),
                b.min().z(),
                b.max().x(),
                b.max().y(),
                b.max().z(),
                n.normals,
                n.strength);
    }

    /** Adds the lights of a group that is not empty. */
    void add(LightGroup g) {
        add(g.lowerX, g.lowerY, g.lowerZ, g.upperX, g.upperY, g.upperZ, g.normals, g.strength);
    }

    private void add(
            double x0, double y0, double z0, double x1, double y1, double z1, NormalCone cone, double luminous) {
        if (normals == null) {
            lowerX = x0;
            lowerY = y0;
            lowerZ = z0;
            upperX = x1;
            upperY = y1;
            upperZ = z1;
            normals = cone;
            strength = luminous;
            return;
        }
        lowerX = Math.min(lowerX, x0);
        lowerY = Math.min(lowerY, y0);
        lowerZ = Math.min(lowerZ, z0);
        upperX = Math.max(upperX, x1);
        upperY = Math.max(upperY, y1);
        upperZ = Math.max(upperZ, z1);
        normals = normals.union(cone);
        strength += luminous;
    }

    /** The cost of a node of these lights: strength times the measure of normals times the surface area of the box. */
    double cost() {
        double x = upperX - lowerX;
        double y = upperY - lowerY;
        double z = upperZ - lowerZ;
        double surface = 2 * (x * y + y * z + z * x);
        return strength * normals.measure() * surface;
    }
}
