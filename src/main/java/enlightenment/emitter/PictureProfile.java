package enlightenment.emitter;

import enlightenment.math.Vec3;
import enlightenment.sampling.GridDistribution;

/**
 * A projector: the intensity of a direction is the picture at the direction's intersection with a plane across the axis; 0 outside of the
 * picture. Seen from the light along its axis the picture is upright. Directions are sampled by cells of the picture: a cell by its
 * brightness times its solid angle, a place in it uniformly.
 */
public final class PictureProfile implements IntensityProfile {
    /** The largest number of cells; of larger pictures a cell has several texels. */
    private static final int MOST_CELLS = 1 << 20;

    /** The least number of points along each side in the integral. */
    private static final int POINTS = 512;

    private final Picture picture;

    private final Vec3 axis;
    private final Vec3 right;
    private final Vec3 up;

    /** Half of the picture's width and height on the plane at distance 1. */
    private final double halfWidth;

    private final double halfHeight;

    /** The number of texels along a side of a cell. */
    private final int block;

    private final int columns;
    private final int rows;
    private final GridDistribution cells;
    private final double solidAngle;

    /** A picture by its coordinates: u to the right, v downwards, 0..1. Immutable. */
    public interface Picture {
        /** Columns of texels. */
        int width();

        /** Rows of texels. */
        int height();

        /**
         * Looks up linear light.
         *
         * @param rgb receives it, 0..1 by band
         */
        void lookUp(double u, double v, double[] rgb);

        /** Numbers that differ between different pictures. */
        double[] identity();
    }

    /**
     * Makes a projector.
     *
     * @param axis unit vector through the middle of the picture
     * @param up unit vector across the axis, to the upper edge of the picture
     * @param fieldOfView across the width of the picture, in degrees: above 0, below 180
     */
    public PictureProfile(Picture picture, Vec3 axis, Vec3 up, double fieldOfView) {
        this.picture = picture;
        this.axis = axis;
        this.up = up;
        right = up.cross(axis);
        halfWidth = StrictMath.tan(0.5 * StrictMath.toRadians(fieldOfView));
        halfHeight = halfWidth * picture.height() / picture.width();
        int texels = 1;
        while ((long) cells(picture.width(), texels) * cells(picture.height(), texels) > MOST_CELLS) {
            texels *= 2;
        }
        block = texels;
        columns = cells(picture.width(), block);
        rows = cells(picture.height(), block);
        cells = new GridDistribution(columns, rows, weights());
        solidAngle = integral();
    }

    private static int cells(int texels, int block) {
        return (texels + block - 1) / block;
    }

    /**
     * The weight of each cell: mean brightness of its texels and of a ring around them, which interpolation mixes in, times its solid
     * angle.
     */
    private double[] weights() {
        double[] weights = new double[(columns + 1) * rows];
        // The lines of texels of a row of cells and its ring; each is looked up once.
        double[][] lines = new double[block + 2][picture.width()];
        int known = 0;
        for (int row = 0; row < rows; row++) {
            int top = row * block;
            int bottom = Math.min(top + block, picture.height());
            int last = Math.min(bottom + 1, picture.height());
            for (; known < last; known++) {
                lookUpLine(known, lines[known % lines.length]);
            }
            for (int c = 0; c < columns; c++) {
                int left = c * block;
                int end = Math.min(left + block, picture.width());
                double sum = 0;
                for (int y = Math.max(top - 1, 0); y < last; y++) {
                    for (int x = Math.max(left - 1, 0); x < Math.min(end + 1, picture.width()); x++) {
                        boolean isInside = y >= top && y < bottom && x >= left && x < end;
                        sum += (isInside ? 1 : 0.125) * lines[y % lines.length][x];
                    }
                }
                double u = 0.5 * (left + end) / picture.width();
                double v = 0.5 * (top + bottom) / picture.height();
                weights[row * (columns + 1) + c + 1] = sum * cubedCosine(u, v);
            }
        }
        return weights;
    }

    private void lookUpLine(int y, double[] brightness) {
        double[] rgb = new double[3];
        for (int x = 0; x < brightness.length; x++) {
            picture.lookUp((x + 0.5) / brightness.length, (y + 0.5) / picture.height(), rgb);
            brightness[x] = luminance(rgb);
        }
    }

    private static double luminance(double[] rgb) {
        return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
    }

    /** The solid angle per area on the plane at distance 1. */
    private double cubedCosine(double u, double v) {
        double x = (2 * u - 1) * halfWidth;
        double y = (1 - 2 * v) * halfHeight;
        double square = 1 + x * x + y * y;
        return 1 / (square * Math.sqrt(square));
    }

    /** The integral of luminance by the midpoint rule, with whole numbers of points in each texel. */
    private double integral() {
        int across = picture.width() * cells(POINTS, picture.width());
        int down = picture.height() * cells(POINTS, picture.height());
        double[] rgb = new double[3];
        double sum = 0;
        for (int y = 0; y < down; y++) {
            double ofRow = 0;
            double v = (y + 0.5) / down;
            for (int x = 0; x < across; x++) {
                double u = (x + 0.5) / across;
                picture.lookUp(u, v, rgb);
                ofRow += luminance(rgb) * cubedCosine(u, v);
            }
            sum += ofRow / across;
        }
        return 4 * halfWidth * halfHeight * sum / down;
    }

    @Override
    public void intensity(double dx, double dy, double dz, double[] rgb) {
        double along = dx * axis.x() + dy * axis.y() + dz * axis.z();
        double u = u(dx, dy, dz, along);
        double v = v(dx, dy, dz, along);
        if (along > 0 && u >= 0 && u <= 1 && v >= 0 && v <= 1) {
            picture.lookUp(u, v, rgb);
        } else {
            rgb[0] = 0;
            rgb[1] = 0;
            rgb[2] = 0;
        }
    }

    private double u(double dx, double dy, double dz, double along) {
        double x = dx * right.x() + dy * right.y() + dz * right.z();
        return 0.5 * (1 + x / (along * halfWidth));
    }

    private double v(double dx, double dy, double dz, double along) {
        double y = dx * up.x() + dy * up.y() + dz * up.z();
        return 0.5 * (1 - y / (along * halfHeight));
    }

    @Override
    public double luminance(double dx, double dy, double dz) {
        double[] rgb = new double[3];
        intensity(dx, dy, dz, rgb);
        return luminance(rgb);
    }

    @Override
    public double sample(double u, double v, double[] out) {
        cells.sample(u, v, out);
        int column = Math.min((int) out[0], columns - 1);
        int row = Math.min((int) out[1], rows - 1);
        double x = (2 * place(column, out[0] - column, picture.width()) - 1) * halfWidth;
        double y = (1 - 2 * place(row, out[1] - row, picture.height())) * halfHeight;
        Vec3 d = axis.plus(right.times(x)).plus(up.times(y)).normalized();
        out[0] = d.x();
        out[1] = d.y();
        out[2] = d.z();
        return density(d.x(), d.y(), d.z());
    }

    /** A position within a cell as a share of the picture's side. */
    private double place(int cell, double within, int texels) {
        int start = cell * block;
        int end = Math.min(start + block, texels);
        return (start + within * (end - start)) / texels;
    }

    @Override
    public double density(double dx, double dy, double dz) {
        double along = dx * axis.x() + dy * axis.y() + dz * axis.z();
        double u = u(dx, dy, dz, along);
        double v = v(dx, dy, dz, along);
        if (!(along > 0 && u >= 0 && u <= 1 && v >= 0 && v <= 1)) {
            return 0;
        }
        int column = Math.min((int) (u * picture.width()) / block, columns - 1);
        int row = Math.min((int) (v * picture.height()) / block, rows - 1);
        double width = place(column, 1, picture.width()) - place(column, 0, picture.width());
        double height = place(row, 1, picture.height()) - place(row, 0, picture.height());
        double area = 4 * halfWidth * halfHeight * width * height;
        return cells.probability(column, row) / (area * along * along * along);
    }

    @Override
    public double solidAngle() {
        return solidAngle;
    }

    @Override
    public Vec3 axis() {
        return axis;
    }

    @Override
    public double coneAngle() {
        return StrictMath.atan(Math.sqrt(halfWidth * halfWidth + halfHeight * halfHeight));
    }

    @Override
    public double[] parameters() {
        double[] own = picture.identity();
        double[] numbers = {axis.x(), axis.y(), axis.z(), up.x(), up.y(), up.z(), halfWidth};
        double[] all = java.util.Arrays.copyOf(numbers, numbers.length + own.length);
        System.arraycopy(own, 0, all, numbers.length, own.length);
        return all;
    }
}
