import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/**
 * Paints the pictures that the example scenes use as textures. A single-file program that needs nothing but a JDK:
 *
 * <pre>java textures/generate/Textures.java textures</pre>
 *
 * <p>Everything is computed from integer hashes with + - * / and StrictMath, so that every machine paints the same pixels.
 * docs/notes/textures.md describes the motifs.
 */
public final class Textures {
    /** A picture as a function of place: u to the right and v downwards, 0..1. */
    interface Painter {
        /** Sets red, green and blue (0..1, display-referred) and returns how far the surface stands out, in texels. */
        double paint(double u, double v, double[] rgb);
    }

    private static final int SAMPLES = 2; // per texel and direction
    private static final double RELIEF = 0.13;
    private static final int STEP = 3; // components are multiples of this: too fine to see, and the files are smaller

    private static final double[] WHITE = color(0xffffff);
    private static final double[] INK = color(0x18181c);

    private final Path folder;

    private Textures(Path folder) {
        this.folder = folder;
    }

    public static void main(String[] arguments) throws IOException {
        if (arguments.length != 1) {
            System.err.println("Usage: java Textures.java FOLDER");
            System.exit(2);
        }
        Textures textures = new Textures(Files.createDirectories(Path.of(arguments[0])));
        textures.write("ice", 1024, 512, Textures::ice);
        textures.write("fire", 1024, 512, Textures::fire);
        textures.write("earth", 1024, 512, new Earth());
        textures.write("wall-left", 512, 512, Textures::bricks);
        textures.write("wall-right", 512, 512, Textures::planks);
        textures.write("wall-back", 512, 512, Textures::stones);
        textures.write("floor", 512, 512, Textures::tiles);
        textures.write("sky", 512, 512, Textures::sky);
        textures.write("orientation", 512, 512, new TestCard());
    }

    /** Paints every texel as the mean of its samples, then lights the relief from the top left. */
    private void write(String name, int width, int height, Painter painter) throws IOException {
        double[][] colors = new double[width * height][3];
        double[] relief = new double[width * height];
        double[] rgb = new double[3];
        double share = 1.0 / (SAMPLES * SAMPLES);
        for (int i = 0; i < width * height * SAMPLES * SAMPLES; i++) {
            int texel = i / (SAMPLES * SAMPLES);
            double x = texel % width + (i % SAMPLES + 0.5) / SAMPLES;
            double y = texel / width + (i / SAMPLES % SAMPLES + 0.5) / SAMPLES;
            relief[texel] += share * painter.paint(x / width, y / height, rgb);
            for (int c = 0; c < 3; c++) {
                colors[texel][c] += share * clamp(rgb[c]);
            }
        }
        byte[][] rows = new byte[height][3 * width];
        for (int y = 0; y < height; y++) {
            // Around a sphere there is no row beyond the poles, and no direction there for light to come from.
            boolean sphere = width > height;
            int up = sphere ? Math.max(0, y - 1) : (y + height - 1) % height;
            int down = sphere ? Math.min(height - 1, y + 1) : (y + 1) % height;
            double strength = RELIEF * (sphere ? StrictMath.sin(StrictMath.PI * (y + 0.5) / height) : 1);
            for (int x = 0; x < width; x++) {
                double across = relief[y * width + (x + 1) % width] - relief[y * width + (x + width - 1) % width];
                double fall = relief[down * width + x] - relief[up * width + x];
                double light = Math.max(0.35, Math.min(1.4, 1 + strength * (0.6 * across + fall)));
                for (int c = 0; c < 3; c++) {
                    double levels = 255.0 / STEP;
                    int level = (int) (clamp(colors[y * width + x][c] * light) * levels + 0.5);
                    rows[y][3 * x + c] = (byte) (level * STEP);
                }
            }
        }
        Files.write(folder.resolve(name + ".png"), png(width, height, rows));
    }

    // ---- PNG (the JDK's own writer makes files that are half as large again)

    private static byte[] png(int width, int height, byte[][] rows) throws IOException {
        ByteArrayOutputStream filtered = new ByteArrayOutputStream();
        byte[] above = new byte[3 * width];
        for (byte[] row : rows) {
            byte[] best = difference(0, row, above);
            for (int type = 1; type < 5; type++) {
                byte[] candidate = difference(type, row, above);
                best = size(candidate) < size(best) ? candidate : best;
            }
            filtered.writeBytes(best);
            above = row;
        }
        ByteArrayOutputStream compressed = new ByteArrayOutputStream();
        try (DeflaterOutputStream deflater = new DeflaterOutputStream(compressed, new Deflater(9))) {
            filtered.writeTo(deflater);
        }
        ByteBuffer header = ByteBuffer.allocate(13).putInt(width).putInt(height).put(new byte[] {8, 2, 0, 0, 0});
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        png.writeBytes(new byte[] {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10});
        chunk(png, "IHDR", header.array());
        chunk(png, "sRGB", new byte[1]);
        chunk(png, "IDAT", compressed.toByteArray());
        chunk(png, "IEND", new byte[0]);
        return png.toByteArray();
    }

    /** A row, preceded by the filter's number, less what the filter predicts from the left (a), above (b) and both (c). */
    private static byte[] difference(int type, byte[] row, byte[] above) {
        byte[] result = new byte[row.length + 1];
        result[0] = (byte) type;
        for (int i = 0; i < row.length; i++) {
            int a = i < 3 ? 0 : row[i - 3] & 255;
            int b = above[i] & 255;
            int c = i < 3 ? 0 : above[i - 3] & 255;
            int toA = Math.abs(b - c);
            int toB = Math.abs(a - c);
            int toC = Math.abs(a + b - 2 * c);
            int paeth = toA <= toB && toA <= toC ? a : toB <= toC ? b : c;
            int[] predictions = {0, a, b, (a + b) / 2, paeth};
            result[i + 1] = (byte) (row[i] - predictions[type]);
        }
        return result;
    }

    private static int size(byte[] differences) {
        int sum = 0;
        for (int i = 1; i < differences.length; i++) {
            sum += Math.abs(differences[i]);
        }
        return sum;
    }

    private static void chunk(ByteArrayOutputStream png, String type, byte[] data) {
        ByteBuffer content = ByteBuffer.allocate(4 + data.length);
        content.put(type.getBytes(StandardCharsets.US_ASCII)).put(data);
        CRC32 crc = new CRC32();
        crc.update(content.array());
        ByteBuffer whole = ByteBuffer.allocate(data.length + 12).putInt(data.length).put(content.array());
        png.writeBytes(whole.putInt((int) crc.getValue()).array());
    }

    // ---- spheres: noise in space on the unit sphere, so that there is neither a seam nor a pinch at the poles

    private static double ice(double u, double v, double[] rgb) {
        double[] p = onSphere(u, v);
        double bend = 0.3;
        double wx = p[0] + bend * fbm(2 * p[0], 2 * p[1], 2 * p[2], 3, 11);
        double wy = p[1] + bend * fbm(2 * p[0], 2 * p[1], 2 * p[2], 3, 12);
        double wz = p[2] + bend * fbm(2 * p[0], 2 * p[1], 2 * p[2], 3, 13);
        double depth = smooth(-0.5, 0.5, fbm(1.1 * wx, 1.1 * wy, 1.1 * wz, 3, 14));
        double line = Math.abs(fbm(1.25 * wx, 1.25 * wy, 1.25 * wz, 4, 15));
        double wide = 1 - smooth(0.006, 0.04, line);
        double glow = 1 - smooth(0, 0.3, line);
        double fine = 1 - smooth(0.004, 0.03, Math.abs(fbm(2.8 * wx, 2.8 * wy, 2.8 * wz, 3, 16)));
        fine *= smooth(-0.1, 0.2, fbm(1.5 * p[0], 1.5 * p[1], 1.5 * p[2], 2, 19)); // only here and there
        double frost = smooth(0.05, 0.5, fbm(2.2 * p[0], 2.2 * p[1], 2.2 * p[2], 4, 18) + 0.3 * glow);
        ramp(rgb, depth, 0x4a89c2, 0x74add9, 0xa0cdec, 0xc0e0f4);
        blend(rgb, color(0xd6ecf9), 0.5 * glow * glow);
        blend(rgb, color(0xe6f4fb), 0.5 * frost);
        blend(rgb, color(0xf4fbff), 0.5 * fine);
        blend(rgb, WHITE, 0.95 * wide);
        return 1.8 * wide + 0.5 * fine + 1.5 * frost;
    }

    private static double fire(double u, double v, double[] rgb) {
        double[] p = onSphere(u, v);
        double x = 1.1 * p[0];
        double y = 0.9 * p[1];
        double z = 1.1 * p[2];
        // Noise that displaces noise that displaces noise: the folds of rising flames.
        double ax = fbm(x, y, z, 3, 21);
        double ay = fbm(x, y, z, 3, 22);
        double az = fbm(x, y, z, 3, 23);
        double bx = fbm(x + 1.3 * ax, y + 1.3 * ay, z + 1.3 * az, 3, 24);
        double by = fbm(x + 1.3 * ax, y + 1.3 * ay, z + 1.3 * az, 3, 25);
        double heat = fbm(x + 1.7 * bx, y + 1.7 * by, z + 1.7 * ax, 4, 26);
        double thread = 1 - smooth(0, 0.16, Math.abs(fbm(1.5 * x + bx, 1.5 * y + by, 1.5 * z + az, 3, 27)));
        double t = 0.4 + 0.95 * heat + 0.5 * bx + 0.16 * thread;
        ramp(rgb, t, 0x240603, 0x541004, 0x932706, 0xc9490b, 0xea7712, 0xf9a528, 0xffd25a, 0xfff2b8, 0xffffff);
        return 0;
    }

    /** A made-up planet with graticule and labels: turned or mirrored, it shows. */
    private static final class Earth implements Painter {
        private final Lettering lettering = new Lettering();

        Earth() {
            String[] names = {"180", "150W", "120W", "90W", "60W", "30W", "0", "30E", "60E", "90E", "120E", "150E"};
            for (int i = 0; i < names.length; i++) {
                lettering.add(names[i], i / 12.0 + 0.004, 0.5 + 0.009, 1 / 720.0, 1 / 360.0);
            }
            String[] north = {"60N", "30N", "30S", "60S"};
            double[] rows = {1 / 6.0, 2 / 6.0, 4 / 6.0, 5 / 6.0};
            for (int i = 0; i < north.length; i++) {
                lettering.add(north[i], 0.504, rows[i] + 0.009, 1 / 720.0, 1 / 360.0);
            }
        }

        @Override
        public double paint(double u, double v, double[] rgb) {
            double[] p = onSphere(u, v);
            double wx = p[0] + 0.3 * fbm(2.5 * p[0], 2.5 * p[1], 2.5 * p[2], 5, 31);
            double wz = p[2] + 0.3 * fbm(2.5 * p[0], 2.5 * p[1], 2.5 * p[2], 5, 32);
            double land = fbm(1.25 * wx, 1.25 * p[1], 1.25 * wz, 6, 36) + 0.02;
            double ridges = 1 - Math.abs(fbm(4 * wx, 4 * p[1], 4 * wz, 5, 34)) * 2.2;
            double latitude = Math.abs(p[1]);
            double cold = latitude + 0.1 * fbm(4 * p[0], 4 * p[1], 4 * p[2], 5, 35);
            double rise = 0;
            if (land < 0) {
                ramp(rgb, 1 + 2.6 * land, 0x0a2348, 0x0f3566, 0x164a86, 0x2268a6, 0x4a9cc4);
            } else {
                double high = land * (0.35 + 0.65 * clamp(ridges));
                double dry = smooth(0.1, 0.3, cold) * (1 - smooth(0.45, 0.6, cold));
                dry *= smooth(-0.15, 0.25, fbm(2 * p[0], 2 * p[1], 2 * p[2], 4, 37) + 0.1);
                ramp(rgb, 2.4 * high, 0x4f8a3c, 0x3f7433, 0x5b7a3a, 0x86774a, 0x8d7a62, 0xb9ada0);
                double[] sand = {0.83, 0.73, 0.5};
                blend(rgb, sand, 0.85 * dry * (1 - smooth(0.15, 0.35, high)));
                double[] tundra = {0.58, 0.6, 0.5};
                blend(rgb, tundra, smooth(0.66, 0.8, cold));
                blend(rgb, WHITE, smooth(0.42, 0.56, high + 0.2 * smooth(0.5, 0.9, cold)));
                rise = 26 * high;
            }
            double cap = smooth(0.9, 0.915, cold);
            blend(rgb, color(0xf2f7fb), cap);
            blend(rgb, WHITE, graticule(u, v, latitude));
            for (int shadow = 0; shadow < 4; shadow++) {
                double du = (shadow % 2 * 2 - 1) * 0.0011;
                blend(rgb, color(0x101820), 0.55 * lettering.at(u + du, v + (shadow / 2 * 2 - 1) * 0.0022));
            }
            blend(rgb, color(0xffef9a), lettering.at(u, v));
            return rise * (1 - cap);
        }

        /** Lines at every 30 degrees, of even width on the sphere; the equator and longitude 0 are stronger. */
        private static double graticule(double u, double v, double latitude) {
            double aroundPole = StrictMath.sqrt(Math.max(1e-9, 1 - latitude * latitude));
            double meridian = Math.abs(u * 12 - Math.rint(u * 12)) / 12 * 1024 * aroundPole;
            double parallel = Math.abs(v * 6 - Math.rint(v * 6)) / 6 * 512;
            boolean strong = Math.abs(u - 0.5) < 0.02;
            double a = latitude < 0.97 ? (strong ? 0.75 : 0.4) * (1 - smooth(0.4, strong ? 2 : 1.3, meridian)) : 0;
            strong = Math.abs(v - 0.5) < 0.02;
            double b = v > 0.05 && v < 0.95 ? (strong ? 0.75 : 0.4) * (1 - smooth(0.4, strong ? 2 : 1.3, parallel)) : 0;
            return Math.max(a, b);
        }
    }

    // ---- walls, floor and sky: patterns that continue seamlessly on all four sides

    private static double bricks(double u, double v, double[] rgb) {
        int row = (int) Math.floor(v * 14);
        double along = u * 6 + (row % 2) * 0.5;
        int brick = Math.floorMod((int) Math.floor(along), 6);
        double x = (along - Math.floor(along) - 0.5) * 512 / 6;
        double y = (v * 14 - row - 0.5) * 512 / 14;
        double rough = tiled(u, v, 32, 4, 41);
        double inside = -box(x, y, 512 / 12.0 - 2.2, 512 / 28.0 - 2.2, 4) + 1.6 * rough;
        double mask = smooth(-0.3, 1.2, inside);
        double tone = unit(brick, row, 42);
        ramp(rgb, tone, 0x6f2f28, 0x8e3b2c, 0xa6452f, 0xb4512f, 0xbd6138);
        double stain = tiled(u, v, 7, 5, 43);
        blend(rgb, unit(brick, row, 44) < 0.14 ? color(0x3a2a2a) : color(0xd08a5e), clamp(0.12 + 0.5 * stain));
        shade(rgb, 1 + 0.22 * rough + 0.1 * tiled(u, v, 128, 2, 45));
        double[] mortar = color(0xb9b1a3);
        shade(mortar, 0.95 + 0.2 * tiled(u, v, 64, 3, 46));
        blend(mortar, color(0x8c857a), clamp(0.3 + stain));
        blend(rgb, mortar, 1 - mask);
        return 2.6 * smooth(-0.5, 4, inside) + 1.3 * rough * mask;
    }

    private static double planks(double u, double v, double[] rgb) {
        int plank = (int) Math.floor(u * 6);
        double x = u * 6 - plank - 0.5;
        double shift = unit(plank, 1, 51);
        double y = v + shift - Math.floor(v + shift);
        // Growth rings, cut lengthwise: nearly parallel lines that bend around a knot.
        double knotX = x - 0.55 * (unit(plank, 2, 51) - 0.5);
        double knotY = (y - 0.5) * 2.6;
        double knot = 1 / (1 + 60 * (knotX * knotX + knotY * knotY));
        double wave = noise(1.3 * x + 9 * plank, 3 * y, 0.5, 0, 3, 52);
        double ring = 9 * x + 2.2 * wave + 5.5 * knot + 0.6 * noise(5 * x + 31 * plank, 8 * y, 2.5, 0, 8, 53);
        double phase = ring - Math.floor(ring);
        double late = smooth(0.1, 0.85, phase) * (1 - smooth(0.88, 1, phase));
        double fibre = noise(150 * u, 6 * v, 0, 150, 6, 54) + 0.6 * noise(300 * u, 12 * v, 1, 300, 12, 55);
        ramp(rgb, unit(plank, 3, 51), 0xa9713c, 0xb98048, 0xc48c52, 0xb07742);
        blend(rgb, color(0x6e4220), 0.62 * late);
        blend(rgb, color(0x3b2213), smooth(0.35, 0.95, knot) * 0.9);
        shade(rgb, 1 + 0.16 * fibre + 0.1 * tiled(u, v, 3, 3, 56));
        double gap = 512 / 12.0 - Math.abs(x) * 512 / 6;
        blend(rgb, color(0x1d110a), 1 - smooth(0.6, 2.2, gap));
        return 2.2 * smooth(0.5, 4, gap) - 0.9 * late + 0.8 * fibre;
    }

    private static double stones(double u, double v, double[] rgb) {
        int row = (int) Math.floor(v * 8);
        // Joints at uneven distances; the one that is left of u, and its neighbour.
        int stone = (int) Math.floor(u * 4) + 1;
        while (joint(stone, row) > u) {
            stone--;
        }
        double left = joint(stone, row);
        double right = joint(stone + 1, row);
        int identity = Math.floorMod(stone, 4);
        double x = (u - (left + right) / 2) * 512;
        double y = (v * 8 - row - 0.5) * 64;
        double rough = tiled(u, v, 24, 5, 61);
        double inside = -box(x, y, (right - left) * 256 - 1.8, 30.2, 7) + 2 * rough;
        double mask = smooth(-0.5, 1.4, inside);
        ramp(rgb, unit(identity, row, 62), 0x8b8a88, 0xa09c95, 0x9297a3, 0xb0a798, 0x9ea3a6);
        double cloud = tiled(u, v, 6, 6, 63 + identity + 4 * row);
        shade(rgb, 1 + 0.38 * cloud + 0.16 * rough);
        double vein = 1 - smooth(0, 0.05, Math.abs(tiled(u, v, 5, 5, 99 + identity + 4 * row)));
        blend(rgb, color(0xd4d0c8), 0.22 * vein);
        blend(rgb, color(0x6f7a52), 0.4 * smooth(0.12, 0.5, tiled(u, v, 4, 5, 64)) * (1 - smooth(2, 14, inside)));
        double[] joint = color(0x57544f);
        shade(joint, 1 + 0.3 * rough);
        blend(rgb, joint, 1 - mask);
        return 3.2 * smooth(-0.5, 6, inside) + 3 * rough * mask;
    }

    private static double joint(int stone, int row) {
        double jitter = 0.34 * (unit(Math.floorMod(stone, 4), row, 65) - 0.5);
        return (stone + (row % 2) * 0.5 + jitter) / 4;
    }

    private static double tiles(double u, double v, double[] rgb) {
        int column = (int) Math.floor(u * 8);
        int row = (int) Math.floor(v * 8);
        int seed = 70 + 9 * (column + 8 * row);
        double x = (u * 8 - column - 0.5) * 64;
        double y = (v * 8 - row - 0.5) * 64;
        double inside = -box(x, y, 31.2, 31.2, 2);
        double a = 0.035 * x;
        double b = 0.035 * y;
        double bend = fbm(a, b, 0.5, 3, seed);
        double cloud = fbm(1.4 * a + bend, 1.4 * b, 1.5, 3, seed + 1);
        double vein = 1 - smooth(0, 0.07, Math.abs(fbm(0.6 * a + 0.7 * bend, 0.6 * b - 0.7 * bend, 2.5, 3, seed + 2)));
        if ((column + row) % 2 == 0) {
            ramp(rgb, 0.5 + cloud, 0xd2cabb, 0xe2dccf, 0xeeeae1);
            blend(rgb, color(0xa4988a), 0.5 * vein);
        } else {
            ramp(rgb, 0.5 + cloud, 0x2b343b, 0x3a464e, 0x4c5a63);
            blend(rgb, color(0x9fb0ba), 0.45 * vein);
        }
        shade(rgb, 1 + 0.05 * (unit(column, row, 71) - 0.5));
        blend(rgb, color(0x78736b), 1 - smooth(-0.4, 0.8, inside));
        return 1.1 * smooth(-0.5, 2.5, inside);
    }

    private static double sky(double u, double v, double[] rgb) {
        double here = cloud(u, v, 6);
        double sunwards = cloud(u - 0.025, v - 0.045, 3); // more cloud on the way to the sun: more shadow
        ramp(rgb, 0.5 + 0.8 * tiled(u, v, 2, 2, 81), 0x2f6fc0, 0x3f82d0, 0x5596dc);
        double veil = smooth(-0.3, 0.5, tiled(u + 0.1 * tiled(u, v, 3, 2, 86), v, 2, 5, 82));
        blend(rgb, color(0xc6ddf4), 0.5 * veil);
        double[] lit = color(0xffffff);
        double thick = smooth(0.15, 0.8, here);
        blend(lit, color(0xb4c0d2), 0.9 * thick * smooth(-0.1, 0.8, sunwards));
        blend(lit, WHITE, 0.5 * smooth(0, 0.5, here - sunwards));
        blend(rgb, lit, 0.97 * smooth(-0.12, 0.5, here));
        return 0;
    }

    private static double cloud(double u, double v, int octaves) {
        double x = u + 0.05 * tiled(u, v, 5, 3, 83);
        double y = v + 0.05 * tiled(u, v, 5, 3, 84);
        return 1.8 * tiled(x, y, 3, octaves, 85) + 0.5 * tiled(u, v, 2, 2, 87) - 0.05;
    }

    /** Four colours, an arrow up, an F and two words: shows what is turned, mirrored, stretched or cut off. */
    private static final class TestCard implements Painter {
        private static final int[] QUADRANTS = {0xd8574a, 0x4f9a4c, 0x3d74c4, 0xe3b83a};
        private final Lettering lettering = new Lettering();

        TestCard() {
            lettering.add("LEFT", 0.06, 0.47, 1 / 96.0, 1 / 96.0);
            lettering.add("RIGHT", 0.64, 0.47, 1 / 96.0, 1 / 96.0);
            lettering.add("TOP", 0.41, 0.045, 1 / 96.0, 1 / 96.0);
            lettering.add("BOTTOM", 0.32, 0.88, 1 / 96.0, 1 / 96.0);
            lettering.add("F", 0.69, 0.12, 1 / 24.0, 1 / 24.0);
            lettering.add("1", 0.13, 0.15, 1 / 40.0, 1 / 40.0);
            lettering.add("2", 0.88, 0.15, 1 / 64.0, 1 / 64.0);
            lettering.add("3", 0.13, 0.66, 1 / 40.0, 1 / 40.0);
            lettering.add("4", 0.76, 0.66, 1 / 40.0, 1 / 40.0);
        }

        @Override
        public double paint(double u, double v, double[] rgb) {
            set(rgb, color(QUADRANTS[(u < 0.5 ? 0 : 1) + (v < 0.5 ? 0 : 2)]));
            if (((int) (u * 16) + (int) (v * 16)) % 2 == 0) {
                blend(rgb, WHITE, 0.14);
            }
            double x = Math.abs(u - 0.5);
            double fromCentre = StrictMath.sqrt(x * x + (v - 0.5) * (v - 0.5));
            if (Math.abs(fromCentre - 0.42) < 0.004) {
                set(rgb, WHITE);
            }
            boolean shaft = x < 0.035 && v > 0.32 && v < 0.82;
            boolean tip = v > 0.15 && v < 0.35 && x < 0.65 * (v - 0.15);
            if (shaft || tip) {
                set(rgb, INK);
            }
            double edge = Math.min(Math.min(u, 1 - u), Math.min(v, 1 - v)) * 512;
            if (edge < 8) {
                set(rgb, edge < 2 ? WHITE : INK);
            }
            blend(rgb, INK, lettering.at(u - 0.004, v - 0.004));
            blend(rgb, WHITE, lettering.at(u, v));
            return 0;
        }
    }

    // ---- letters of 5 x 7 dots

    private static final class Lettering {
        private static final String KNOWN = "0123456789BEFGHILMNOPRSTW";
        /** Per letter seven rows of five dots, one base-32 digit (0-9, A-V) each, the leftmost dot highest. */
        private static final String[] DOTS = {
            "EHJLPHE", "4C4444E", "EH1248V", "V2421HE", "26AIV22", "VGU11HE", "68GUHHE", "V124888", "EHHEHHE", "EHHF12C",
            "UHHUHHU", "VGGUGGV", "VGGUGGG", "EHGNHHF", "HHHVHHH", "E44444E", "GGGGGGV", "HRLLHHH", "HHPLJHH", "EHHHHHE",
            "UHHUGGG", "UHHUKIH", "FGGE11U", "V444444", "HHHLLLA"
        };

        private final List<double[]> places = new ArrayList<>();

        /** Adds a word: place of its top left corner, size of a dot. */
        void add(String word, double u, double v, double dotWidth, double dotHeight) {
            for (int i = 0; i < word.length(); i++) {
                int letter = KNOWN.indexOf(word.charAt(i));
                places.add(new double[] {u + 6 * i * dotWidth, v, dotWidth, dotHeight, letter});
            }
        }

        /** 1 on a letter, 0 elsewhere. */
        double at(double u, double v) {
            for (double[] place : places) {
                int column = (int) Math.floor((u - place[0]) / place[2]);
                int row = (int) Math.floor((v - place[1]) / place[3]);
                if (column >= 0 && column < 5 && row >= 0 && row < 7) {
                    return Character.digit(DOTS[(int) place[4]].charAt(row), 32) >> 4 - column & 1;
                }
            }
            return 0;
        }
    }

    // ---- noise

    private static double[] onSphere(double u, double v) {
        double longitude = 2 * StrictMath.PI * u;
        double polar = StrictMath.PI * v;
        double radius = StrictMath.sin(polar);
        return new double[] {
            radius * StrictMath.cos(longitude), StrictMath.cos(polar), radius * StrictMath.sin(longitude)
        };
    }

    /** Noise of ever finer detail, about -0.7..0.7. */
    private static double fbm(double x, double y, double z, int octaves, int seed) {
        return octaves(x, y, z, 0, octaves, seed);
    }

    /** The same, but repeating when u or v grows by 1. */
    private static double tiled(double u, double v, int frequency, int octaves, int seed) {
        return octaves(u * frequency, v * frequency, 0.5, frequency, octaves, seed);
    }

    private static double octaves(double x, double y, double z, int period, int octaves, int seed) {
        double sum = 0;
        for (int i = 0; i < octaves; i++) {
            double scale = 1 << i;
            sum += noise(x * scale, y * scale, z * scale, period << i, period << i, seed + 1000 * i) / scale;
        }
        return 0.75 * sum;
    }

    /** Gradient noise; a period above 0 makes it repeat along x or y. */
    private static double noise(double x, double y, double z, int periodX, int periodY, int seed) {
        double floorX = Math.floor(x);
        double floorY = Math.floor(y);
        double floorZ = Math.floor(z);
        double fx = x - floorX;
        double fy = y - floorY;
        double fz = z - floorZ;
        double sum = 0;
        for (int corner = 0; corner < 8; corner++) {
            int dx = corner & 1;
            int dy = corner >> 1 & 1;
            int dz = corner >> 2;
            int ix = (int) floorX + dx;
            int iy = (int) floorY + dy;
            int bits = hash(periodX > 0 ? Math.floorMod(ix, periodX) : ix,
                    periodY > 0 ? Math.floorMod(iy, periodY) : iy, (int) floorZ + dz, seed);
            double weight = ease(dx == 0 ? 1 - fx : fx) * ease(dy == 0 ? 1 - fy : fy) * ease(dz == 0 ? 1 - fz : fz);
            sum += weight * slope(bits, fx - dx, fy - dy, fz - dz);
        }
        return sum;
    }

    /** The rise along (x, y, z) of one of twelve gradients, those to the edges of a cube. */
    private static double slope(int bits, double x, double y, double z) {
        int which = (bits >>> 8) % 3;
        double a = which == 0 ? y : x;
        double b = which == 2 ? y : z;
        return ((bits & 1) == 0 ? a : -a) + ((bits & 2) == 0 ? b : -b);
    }

    private static int hash(int x, int y, int z, int seed) {
        int h = seed * 0x632be5ab + x * 0x1b873593 + y * 0x5851f42d + z * 0x27d4eb2f;
        h = (h ^ h >>> 15) * 0x2c1b3c6d;
        h = (h ^ h >>> 12) * 0x297a2d39;
        return h ^ h >>> 15;
    }

    /** A number in 0..1 that belongs to two integers. */
    private static double unit(int x, int y, int seed) {
        return (hash(x, y, 0, seed) >>> 8) / 16777216.0;
    }

    // ---- arithmetic on numbers and colours

    private static double ease(double t) {
        return t * t * t * (t * (t * 6 - 15) + 10);
    }

    private static double clamp(double t) {
        return Math.max(0, Math.min(1, t));
    }

    /** 0 up to the first place, 1 from the second on, smooth between. */
    private static double smooth(double from, double to, double t) {
        double s = clamp((t - from) / (to - from));
        return s * s * (3 - 2 * s);
    }

    /** The distance to a rectangle around 0 with rounded corners; negative inside. */
    private static double box(double x, double y, double halfWidth, double halfHeight, double rounding) {
        double dx = Math.abs(x) - halfWidth + rounding;
        double dy = Math.abs(y) - halfHeight + rounding;
        double outX = Math.max(0, dx);
        double outY = Math.max(0, dy);
        return StrictMath.sqrt(outX * outX + outY * outY) + Math.min(0, Math.max(dx, dy)) - rounding;
    }

    private static double[] color(int packed) {
        return new double[] {(packed >> 16) / 255.0, (packed >> 8 & 255) / 255.0, (packed & 255) / 255.0};
    }

    private static void set(double[] rgb, double[] value) {
        System.arraycopy(value, 0, rgb, 0, 3);
    }

    private static void blend(double[] rgb, double[] other, double share) {
        for (int c = 0; c < 3; c++) {
            rgb[c] += clamp(share) * (other[c] - rgb[c]);
        }
    }

    private static void shade(double[] rgb, double factor) {
        for (int c = 0; c < 3; c++) {
            rgb[c] *= factor;
        }
    }

    /** The colour at 0..1 of the way through a list of colours. */
    private static void ramp(double[] rgb, double t, int... colors) {
        double place = clamp(t) * (colors.length - 1);
        int index = Math.min((int) place, colors.length - 2);
        set(rgb, color(colors[index]));
        blend(rgb, color(colors[index + 1]), place - index);
    }
}
