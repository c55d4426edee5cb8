package enlightenment.physical;

import enlightenment.math.Vec3;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;

/** Light from infinity, looked up in the plainest way: of pictures those in PFM files of colours, little-endian. */
interface NaiveSky {
    double[] radiance(Vec3 direction);

    static NaiveSky of(Shading.Background background) {
        if (background instanceof Shading.Background.Constant c) {
            double[] radiance = NaiveColors.of(c.radiance());
            return d -> radiance;
        }
        Shading.Background.Picture p = (Shading.Background.Picture) background;
        double[] factor = NaiveColors.of(p.radiance());
        double turn = Math.toRadians(p.rotation());
        Texels texels = Texels.read(p);
        return d -> {
            Vec3 unit = d.times(1 / d.length());
            double angle = Math.atan2(unit.x(), unit.z()) - turn;
            double u = angle / (2 * Math.PI) + 0.5;
            double v = Math.acos(Math.max(-1, Math.min(1, unit.y()))) / Math.PI;
            return NaiveColors.product(factor, texels.between(u * texels.width - 0.5, v * texels.height - 0.5));
        };
    }

    /** A picture's numbers. */
    record Texels(int width, int height, ByteBuffer floats) {
        static Texels read(Shading.Background.Picture p) {
            try {
                byte[] file = Files.readAllBytes(p.picture().file());
                String[] head = new String(file, 0, 40, StandardCharsets.ISO_8859_1).split("\\s");
                int width = Integer.parseInt(head[1]);
                int height = Integer.parseInt(head[2]);
                int size = 12 * width * height;
                ByteBuffer floats =
                        ByteBuffer.wrap(file, file.length - size, size).slice();
                return new Texels(width, height, floats.order(ByteOrder.LITTLE_ENDIAN));
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        double[] between(double x, double y) {
            double[] sum = new double[3];
            int x0 = (int) Math.floor(x);
            int y0 = (int) Math.floor(y);
            for (int k = 0; k < 4; k++) {
                int column = x0 + k % 2;
                int row = Math.max(0, Math.min(height - 1, y0 + k / 2));
                double weight = (1 - Math.abs(x - column)) * (1 - Math.abs(y - (y0 + k / 2)));
                int at = 12 * ((height - 1 - row) * width + Math.floorMod(column, width));
                for (int band = 0; band < 3; band++) {
                    sum[band] += weight * floats.getFloat(at + 4 * band);
                }
            }
            return sum;
        }
    }
}
