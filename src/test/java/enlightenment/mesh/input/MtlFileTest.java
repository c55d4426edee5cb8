package enlightenment.mesh.input;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import enlightenment.math.Vec3;
import enlightenment.mesh.input.MtlFile.Material;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MtlFileTest {
    @TempDir
    Path folder;

    private List<Material> read(String text) throws IOException {
        Path file = folder.resolve("a.mtl");
        Files.writeString(file, text);
        return MtlFile.read(file);
    }

    @Test
    void eachValueIsRead() throws IOException {
        String text =
                "# by hand\n\nnewmtl my glass \n Kd 0.1 .2 3e-1\r\nKs 1\nKe 4 5 6\nKa 1 1 1\n\tNs 96.5\nNi 1.5\nd -halo 0.25\n"
                        + "illum 7\nmap_Kd -s 1 2 3 -clamp on my textures\\wood.png\nmap_Ke lamp.png\nmap_d -mm 0 1 leaf.png\n"
                        + "newmtl none\nTr 0.25\nKd spectral a.rfl\n";
        Material glass = new Material(
                "my glass",
                Optional.of(new Vec3(0.1, 0.2, 0.3)),
                Optional.of(new Vec3(1, 1, 1)),
                Optional.of(new Vec3(4, 5, 6)),
                OptionalDouble.of(96.5),
                OptionalDouble.of(1.5),
                OptionalDouble.of(0.25),
                OptionalInt.of(7),
                Optional.of("my textures\\wood.png"),
                Optional.of("lamp.png"),
                Optional.of("leaf.png"));
        List<Material> read = read(text);
        assertEquals(
                List.of("my glass", "none"), read.stream().map(Material::name).toList());
        assertEquals(glass, read.get(0));
        assertEquals(OptionalDouble.of(0.75), read.get(1).d());
        assertEquals(Optional.empty(), read.get(1).kd());
        assertEquals(OptionalInt.empty(), read.get(1).illum());
        assertEquals(List.of(), read("# nothing\n"));
    }

    @Test
    void nonsenseIsRefusedWithItsLine() {
        String[][] cases = {
            {"Kd 1 1 1", "line 1: has Kd before the first newmtl"},
            {"newmtl a\nKd 1 red 1", "line 2: has \"red\" where a number is expected"},
            {"newmtl a\nNs nan", "line 2: has \"nan\" where a number is expected"},
            {"newmtl a\nillum 2.5", "line 2: has \".5\" directly behind a number"},
            {"newmtl a\nillum -1", "line 2: has the illumination model -1; there are 0 to 10"},
            {"newmtl a\nd", "line 2: has the end of the text where a number is expected"},
        };
        for (String[] c : cases) {
            IOException refused = assertThrows(IOException.class, () -> read(c[0]));
            assertEquals(folder.resolve("a.mtl") + ": " + c[1], refused.getMessage());
        }
    }
}
