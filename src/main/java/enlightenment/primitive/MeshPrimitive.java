package enlightenment.primitive;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;
import enlightenment.mesh.tree.MeshRay;
import enlightenment.mesh.tree.TriangleTree;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;
import java.util.Arrays;

/**
 * An instance of a mesh: rays are mapped to its coordinates and traverse its tree. To other classes it is one curved surface;
 * {@link Hit#element} is the triangle. Where the mesh has vertex normals, {@link Hit} has the shading normal.
 */
public final class MeshPrimitive extends Primitive {
    /** The direction in which {@link #contains} searches: one that no edge of a modelled mesh is likely to be parallel to. */
    private static final double[] ASIDE = {0.5773, 0.2911, 0.7631};

    private final TriangleMesh mesh;
    private final Placing placing;
    private final Bounds bounds;

    /** Its number in the {@link MeshUnion} that it was joined to last, a cache of that union's search; −1 if there is none. */
    int likelyMember = -1;

    MeshPrimitive(TriangleMesh mesh, Placing placing) {
        this(mesh, placing, bounds(mesh, placing));
    }

    private MeshPrimitive(TriangleMesh mesh, Placing placing, Bounds bounds) {
        super(bounds.maxAbs(), bounds.extent().maxAbs());
        this.mesh = mesh;
        this.placing = placing;
        this.bounds = bounds;
    }

    private static Bounds bounds(TriangleMesh mesh, Placing placing) {
        Vec3 min = mesh.min();
        Vec3 max = mesh.max();
        PlacedBoxes all = new PlacedBoxes(placing);
        if (placing.keepsAxes()) {
            all.accept(min.x(), min.y(), min.z(), max.x(), max.y(), max.z());
        } else {
            TriangleTree.of(mesh, () -> {}).forEachBox(all);
        }
        return all.bounds(placing.slack(mesh.maxAbs()));
    }

    @Override
    double nearestOrdinary(Ray ray, double tMax) {
        MeshRay local = local(ray);
        if (!local.closest(tMax)) {
            return MISS;
        }
        ray.element = local.triangle;
        return local.t;
    }

    @Override
    boolean blocksOrdinary(Ray ray, double tMax) {
        return local(ray).isBlocked(tMax);
    }

    /** The ray in the mesh's coordinates, with the triangles that it starts on. */
    private MeshRay local(Ray ray) {
        MeshRay local = ray.meshRay();
        place(local, mesh, placing, ray);
        if (ray.start == this) {
            startOn(local, ray.startElement, placing, ray);
        }
        if (ray.special) {
            local.leaveOut(ray.otherElementOf(this));
        }
        return local;
    }

    /** Transforms a ray to the coordinates of a mesh with this placing. */
    static void place(MeshRay local, TriangleMesh of, Placing placing, Ray ray) {
        double x = ray.ox - placing.offset(0);
        double y = ray.oy - placing.offset(1);
        double z = ray.oz - placing.offset(2);
        if (placing.isMove) {
            local.set(of, x, y, z, ray.dx, ray.dy, ray.dz, ray.tMin);
        } else {
            local.set(
                    of,
                    placing.local(0, x, y, z),
                    placing.local(1, x, y, z),
                    placing.local(2, x, y, z),
                    placing.local(0, ray.dx, ray.dy, ray.dz),
                    placing.local(1, ray.dx, ray.dy, ray.dz),
                    placing.local(2, ray.dx, ray.dy, ray.dz),
                    ray.tMin);
        }
    }

    /**
     * Lets a transformed ray, which starts on this mesh, start on a triangle.
     *
     * @param of the placing of the mesh whose tree is traversed: this one's, or that of a union
     */
    void startOn(MeshRay local, int triangle, Placing of, Ray ray) {
        double size = ray.maxAbsOrigin() + placing.maxOffset();
        local.startOn(triangle, ray.startSide, Scale.gamma(16) * size * of.largestInverse());
    }

    /** The placing of the mesh in the frame. */
    Placing placing() {
        return placing;
    }

    @Override
    void completeOrdinary(Ray ray, double t, Hit hit) {
        int triangle = ray.element;
        MeshRay local = local(ray);
        local.complete(triangle);
        hit.element = triangle;
        hit.face = 0;
        hit.weightB = local.weightB;
        hit.weightC = local.weightC;
        double a = 1 - local.weightB - local.weightC;
        Vec3 p = mesh.position(mesh.vertex(triangle, 0));
        Vec3 q = mesh.position(mesh.vertex(triangle, 1));
        Vec3 r = mesh.position(mesh.vertex(triangle, 2));
        Vec3 at = placing.point(
                between(p.x(), q.x(), r.x(), a, local.weightB, local.weightC),
                between(p.y(), q.y(), r.y(), a, local.weightB, local.weightC),
                between(p.z(), q.z(), r.z(), a, local.weightB, local.weightC));
        hit.setPoint(at.x(), at.y(), at.z());
        Vec3 n = mesh.areaNormal(triangle);
        Vec3 normal = placing.isMove ? n : placing.normal(n.x(), n.y(), n.z());
        normal = normal.scaledBy(-normal.exponent());
        hit.setNormal(normal.x(), normal.y(), normal.z());
        hit.side = local.side;
    }

    private static double between(double p, double q, double r, double a, double b, double c) {
        return Math.fma(c, r, Math.fma(b, q, a * p));
    }

    @Override
    public boolean shadingNormal(Hit hit) {
        if (!mesh.hasNormals()) {
            return false;
        }
        double a = 1 - hit.weightB - hit.weightC;
        Vec3 p = mesh.normal(mesh.vertex(hit.element, 0));
        Vec3 q = mesh.normal(mesh.vertex(hit.element, 1));
        Vec3 r = mesh.normal(mesh.vertex(hit.element, 2));
        double x = between(p.x(), q.x(), r.x(), a, hit.weightB, hit.weightC);
        double y = between(p.y(), q.y(), r.y(), a, hit.weightB, hit.weightC);
        double z = between(p.z(), q.z(), r.z(), a, hit.weightB, hit.weightC);
        Vec3 n = placing.isMove ? new Vec3(x, y, z) : placing.normal(x, y, z);
        if (!(n.maxAbs() > 0)) {
            return false;
        }
        n = n.scaledBy(-n.exponent()).normalized();
        double cosine = n.x() * hit.nx + n.y() * hit.ny + n.z() * hit.nz;
        if (!(cosine > 0)) {
            return false;
        }
        hit.sx = n.x();
        hit.sy = n.y();
        hit.sz = n.z();
        return true;
    }

    /**
     * The sum over the corners of the hit's depth below the plane perpendicular to the corner's normal, along that normal, by barycentric
     * weights.
     */
    @Override
    public boolean bulge(Hit hit, double[] offset) {
        if (!mesh.hasNormals()) {
            return false;
        }
        double[] weights = {1 - hit.weightB - hit.weightC, hit.weightB, hit.weightC};
        Vec3[] corners = new Vec3[3];
        Vec3 at = Vec3.ZERO;
        for (int k = 0; k < 3; k++) {
            corners[k] = mesh.position(mesh.vertex(hit.element, k));
            at = at.plus(corners[k].times(weights[k]));
        }
        Vec3 sum = Vec3.ZERO;
        for (int k = 0; k < 3; k++) {
            Vec3 n = mesh.normal(mesh.vertex(hit.element, k));
            if (n.maxAbs() > 0) {
                Vec3 unit = n.normalized().times(hit.side);
                double below = Math.min(0, at.minus(corners[k]).dot(unit));
                sum = sum.minus(unit.times(weights[k] * below));
            }
        }
        Vec3 placed = placing.vector(sum);
        offset[0] = placed.x();
        offset[1] = placed.y();
        offset[2] = placed.z();
        return true;
    }

    /** The interpolated coordinates of the vertices; without any, the triangle's corners are (0, 0), (1, 0) and (0, 1). */
    @Override
    public void textureCoordinates(Hit hit) {
        if (!mesh.hasUv()) {
            hit.u = hit.weightB;
            hit.v = 1 - hit.weightC;
            return;
        }
        double a = 1 - hit.weightB - hit.weightC;
        int p = mesh.vertex(hit.element, 0);
        int q = mesh.vertex(hit.element, 1);
        int r = mesh.vertex(hit.element, 2);
        hit.u = between(mesh.uv(p, 0), mesh.uv(q, 0), mesh.uv(r, 0), a, hit.weightB, hit.weightC);
        hit.v = 1 - between(mesh.uv(p, 1), mesh.uv(q, 1), mesh.uv(r, 1), a, hit.weightB, hit.weightC);
    }

    /** Computed from the triangle's corners; false if their texture coordinates are collinear. */
    @Override
    public boolean textureDirections(Hit hit) {
        int p = mesh.vertex(hit.element, 0);
        int q = mesh.vertex(hit.element, 1);
        int r = mesh.vertex(hit.element, 2);
        Vec3 b = mesh.position(q).minus(mesh.position(p));
        Vec3 c = mesh.position(r).minus(mesh.position(p));
        double bu = mesh.hasUv() ? mesh.uv(q, 0) - mesh.uv(p, 0) : 1;
        double bv = mesh.hasUv() ? mesh.uv(q, 1) - mesh.uv(p, 1) : 0;
        double cu = mesh.hasUv() ? mesh.uv(r, 0) - mesh.uv(p, 0) : 0;
        double cv = mesh.hasUv() ? mesh.uv(r, 1) - mesh.uv(p, 1) : 1;
        double determinant = Products.difference(bu, cv, bv, cu);
        if (determinant == 0) {
            return false;
        }
        Vec3 u = placing.vector(b.times(cv / determinant).minus(c.times(bv / determinant)));
        Vec3 v = placing.vector(c.times(bu / determinant).minus(b.times(cu / determinant)));
        hit.setTextureDirections(u, v);
        return u.isFinite() && v.isFinite();
    }

    @Override
    public boolean hasTextureDirections() {
        return true;
    }

    @Override
    public boolean repeatsTextures() {
        return true;
    }

    @Override
    public int crossings() {
        return mesh.triangles();
    }

    @Override
    public Bounds bounds() {
        return bounds;
    }

    @Override
    public boolean isSolid() {
        return mesh.isClosed();
    }

    @Override
    public double volume() {
        return mesh.volume() * placing.volumeFactor();
    }

    @Override
    public boolean isConvex() {
        return false;
    }

    @Override
    public boolean hasElements() {
        return true;
    }

    @Override
    public boolean isWhole() {
        return true;
    }

    /** Whether the closest triangle in some direction is hit from its inside. */
    @Override
    public boolean contains(double x, double y, double z) {
        if (!isSolid()) {
            return false;
        }
        Ray ray = new Ray().set(x, y, z, ASIDE[0], ASIDE[1], ASIDE[2], 0);
        MeshRay local = local(ray);
        return local.closest(Double.MAX_VALUE) && local.side < 0;
    }

    @Override
    public SupportSurface support(int face) {
        return new SupportSurface.Facets(mesh, bounds, placing.numbers());
    }

    @Override
    public FlatForm flatForm() {
        return new FlatForm(FlatForm.Kind.MESH, placing.flatForm(), mesh);
    }

    @Override
    Primitive scaledBy(int k) {
        return new MeshPrimitive(mesh, placing.scaledBy(k));
    }

    @Override
    public double firstParameter() {
        return placing.offset(0);
    }

    /** The placing, and the digest of the mesh. */
    @Override
    public double[] parameters() {
        double[] placed = placing.numbers();
        String digest = mesh.digest();
        int pieces = 8;
        double[] all = Arrays.copyOf(placed, placed.length + pieces);
        for (int i = 0; i < pieces; i++) {
            all[placed.length + i] = Long.parseLong(digest, 8 * i, 8 * i + 8, 16);
        }
        return all;
    }

    /** The mesh. */
    public TriangleMesh mesh() {
        return mesh;
    }
}
