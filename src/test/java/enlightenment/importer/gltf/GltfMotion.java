package enlightenment.importer.gltf;

import enlightenment.importer.SceneImporter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** An animation of a small glTF file in the making. */
final class GltfMotion {
    private final GltfFile file;
    private final StringBuilder samplers = new StringBuilder();
    private final StringBuilder channels = new StringBuilder();

    GltfMotion(GltfFile file) {
        this.file = file;
    }

    /** Adds a channel. */
    void move(int node, String path, String interpolation, float[] times, float... values) {
        int input = file.floats("SCALAR", 1, times);
        int output = file.floats(path.equals("rotation") ? "VEC4" : "VEC3", path.equals("rotation") ? 4 : 3, values);
        move(node, path, interpolation, input, output);
    }

    /** Adds a channel of accessors. */
    void move(int node, String path, String interpolation, int input, int output) {
        int index = (int) samplers.chars().filter(c -> c == '{').count();
        samplers.append(samplers.isEmpty() ? "" : ",")
                .append("{'input':%d,'output':%d,'interpolation':'%s'}".formatted(input, output, interpolation));
        addChannel("{'sampler':%d,'target':{'node':%d,'path':'%s'}}".formatted(index, node, path));
    }

    void addChannel(String json) {
        channels.append(channels.isEmpty() ? "" : ",").append(json);
    }

    /** Adds the animation to the file. */
    GltfMotion add(String more) {
        file.add("animations", "{'samplers':[" + samplers + "],'channels':[" + channels + "]" + more + "}");
        return this;
    }

    /** Writes the file with the animation to {@code moving.glb} and reads it. */
    SceneImporter.Result read(Path folder, SceneImporter.Options options) throws IOException {
        add("");
        Path glb = folder.resolve("moving.glb");
        Files.write(glb, file.glb());
        return SceneImporter.read(glb, options);
    }
}
