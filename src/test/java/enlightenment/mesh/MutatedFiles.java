package enlightenment.mesh;

import java.util.Arrays;
import java.util.Random;

/** Breaks files at random. */
final class MutatedFiles {
    private MutatedFiles() {}

    /** A copy with one to four changes: bytes, bits, characters of numbers, runs of 0 or 255, moved pieces, and missing ends. */
    static byte[] mutated(byte[] content, Random random) {
        byte[] all = content.clone();
        int changes = 1 + random.nextInt(4);
        for (int i = 0; i < changes; i++) {
            int at = random.nextInt(all.length);
            switch (random.nextInt(6)) {
                case 0 -> all[at] = (byte) random.nextInt(256);
                case 1 -> all[at] ^= (byte) (1 << random.nextInt(8));
                case 2 -> all[at] = (byte) "0123456789-+./\\ \r\n#eEn".charAt(random.nextInt(22));
                case 3 -> Arrays.fill(all, at, Math.min(all.length, at + 4), (byte) (random.nextInt(3) - 1));
                case 4 -> {
                    int from = random.nextInt(all.length);
                    int length = Math.min(random.nextInt(20), all.length - Math.max(at, from));
                    System.arraycopy(all, from, all, at, length);
                }
                default -> all = Arrays.copyOf(all, Math.max(1, all.length - random.nextInt(8)));
            }
        }
        return all;
    }
}
