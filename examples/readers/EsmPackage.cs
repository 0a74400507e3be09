// Reads a model package of the Elastodynamic Shape Modeler, and moves it: by docs/model-package.md alone.
//
// One file to copy, for C# 6 or later and any .NET, Mono or Unity, without other libraries. What is read has the names of
// the specification:
//
//     var package = EsmPackage.Read("liver.glb");
//     float[] lengths = package.Floats("springs", "restLength");          // m
//     var motion = new EsmMotion(package);
//     motion.Forces[12] = new[] {0, 0, -1.0};                             // N, by node
//     motion.Step(1e-4);                                                  // s
//     double[] places = motion.Positions;                                 // x, y, z of every node, m
//     double[] vertices = package.Carried(motion.Positions);              // x, y, z of every drawn vertex, m
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;

/// <summary>What is wrong with a package, in one line.</summary>
public sealed class EsmPackageException : Exception {
    public EsmPackageException(string problem) : base(problem) {}

    internal static void Need(bool condition, string problem) {
        if (!condition) throw new EsmPackageException(problem);
    }
}

/// <summary>What a package holds. Groups that it lacks have no arrays.</summary>
public sealed class EsmPackage {
    private const int NewestVersion = 9, FloatType = 5126, UnsignedType = 5125;
    private const double Largest = 1e30;

    public string Name { get; private set; }
    public int Version { get; private set; }
    /// <summary>Beyond this lengthening, relative to the rest length, springs have another constant; infinite: linear.</summary>
    public double StiffeningStrain { get; private set; }
    /// <summary>How many times their own that constant is.</summary>
    public double StiffeningFactor { get; private set; }
    /// <summary>The extension's JSON: objects are dictionaries, arrays lists, numbers double.</summary>
    public Dictionary<string, object> Json { get; private set; }
    /// <summary>Of each primitive: POSITION, NORMAL, TEXCOORD_0, indices, vertexNodes, vertices, triangles where it has them.</summary>
    public List<Dictionary<string, Array>> Drawn { get; private set; }
    /// <summary>As they lie in the file, PNG or JPEG, by their places in glTF's images.</summary>
    public List<byte[]> Pictures { get; private set; }
    /// <summary>Parts of the simulated surface, and how stiff the fluid in them is, Pa.</summary>
    public List<KeyValuePair<int, double>> Fillings { get; private set; }

    private readonly Dictionary<string, Array> m_arrays = new Dictionary<string, Array>();
    private Dictionary<string, object> m_gltf;
    private byte[] m_text = new byte[0], m_binary = new byte[0];

    // group, key, what it is counted by, numbers for each of these, type of the accessor, and what a number may be
    private static readonly string[][] s_rows = new[] {
        "nodes restPosition nodes.count 3 VEC3 number", "nodes mass nodes.count 1 SCALAR mass",
        "nodes springConstant nodes.count 1 SCALAR amount", "nodes viscosity nodes.count 1 SCALAR amount",
        "springs nodes springs.count 2 SCALAR node", "springs restLength springs.count 1 SCALAR amount",
        "springs springConstant springs.count 1 SCALAR amount", "springs viscosity springs.count 1 SCALAR amount",
        "tethers nodes tethers.count 1 SCALAR node", "tethers springConstant tethers.count 1 SCALAR amount",
        "tethers viscosity tethers.count 1 SCALAR amount", "fixedNodes nodes fixedNodes.count 1 SCALAR node",
        "surface restPosition surface.vertexCount 3 VEC3 number", "surface vertexNodes surface.vertexCount 1 SCALAR node",
        "surface triangles surface.triangleCount 3 SCALAR vertex", "hinges nodes hinges.count 4 SCALAR node",
        "hinges stiffness hinges.count 1 SCALAR amount", "hinges viscosity hinges.count 1 SCALAR amount",
        "binding triangles binding.triangleCount 3 SCALAR node", "binding lines binding.lineCount 2 SCALAR node",
        "sheet springShares springs.count 1 SCALAR positive", "sheet nodeShares nodes.count 1 SCALAR positive",
        "lattice tetrahedra lattice.tetrahedronCount 4 SCALAR node", "lattice springShares springs.count 1 SCALAR positive",
        "lattice triangles lattice.triangleCount 3 SCALAR node"}.Select(row => row.Split(' ')).ToArray();
    private static readonly string[] s_always = {"nodes", "springs", "tethers", "fixedNodes", "surface"};

    /// <summary>Throws EsmPackageException for what is damaged, no package or of a newer version, IOException without a file.</summary>
    public static EsmPackage Read(string path) {
        var package = new EsmPackage();
        try {
            package.ReadContainer(File.ReadAllBytes(path));
            package.ReadModel();
        } catch (Exception reason) when (!(reason is EsmPackageException || reason is IOException || reason is UnauthorizedAccessException)) {
            throw new EsmPackageException("is damaged: " + reason.Message.Split('\n')[0].Trim());
        }
        return package;
    }

    public bool Has(string group) { return Json.ContainsKey(group); }
    /// <summary>Flat, by group and key; empty where there is none.</summary>
    public float[] Floats(string group, string key) { return Found(group, key) as float[] ?? new float[0]; }
    public uint[] Indices(string group, string key) { return Found(group, key) as uint[] ?? new uint[0]; }
    public int NodeCount { get { return Floats("nodes", "mass").Length; } }

    private Array Found(string group, string key) {
        Array array;
        return m_arrays.TryGetValue(group + "." + key, out array) ? array : null;
    }

    private void ReadContainer(byte[] file) {
        EsmPackageException.Need(file.Length >= 20 && Word(file, 0) == 0x46546C67, "is no binary glTF file (.glb)");
        EsmPackageException.Need(Word(file, 4) == 2, "is glTF of another version than 2");
        EsmPackageException.Need(Word(file, 8) == file.Length, "is cut off or damaged: its header speaks of another length");
        for (long place = 12; place + 8 <= file.Length;) {
            long size = Word(file, place), kind = Word(file, place + 4), begin = place + 8;
            EsmPackageException.Need(begin + size <= file.Length, "is damaged: a part reaches beyond its end");
            if (m_gltf == null) {
                EsmPackageException.Need(kind == 0x4E4F534A, "is damaged: its first part is not JSON");
                m_text = file.Skip((int)begin).Take((int)size).ToArray();
                m_gltf = new EsmJson(new UTF8Encoding(false, true).GetString(m_text)).Object();
            } else if (kind == 0x004E4942 && m_binary.Length == 0) {
                m_binary = new byte[size];
                Buffer.BlockCopy(file, (int)begin, m_binary, 0, (int)size);
            }
            place = begin + size;
        }
        EsmPackageException.Need(m_gltf != null, "is damaged: it has no JSON");
    }

    private static uint Word(byte[] file, long place) {
        return (uint)(file[place] | file[place + 1] << 8 | file[place + 2] << 16 | file[place + 3] << 24);
    }

    private void ReadModel() {
        object extensions;
        var all = m_gltf.TryGetValue("extensions", out extensions) ? extensions as Dictionary<string, object> : null;
        EsmPackageException.Need(all != null && all.ContainsKey("ESM_spring_mass"), "is glTF, but no model package");
        Json = (Dictionary<string, object>)all["ESM_spring_mass"];
        Version = Count(Json["version"]);
        EsmPackageException.Need(Version >= 1 && Version <= NewestVersion, "is of version " + Version + ", which this reader does not know");
        EsmPackageException.Need((string)Json["damping"] == "isotropic", "damps in a way that this reader does not know");
        if (Json.ContainsKey("checksums")) CheckSums((uint[])Numbers(Json["checksums"], "SCALAR", ((List<object>)m_gltf["bufferViews"]).Count));
        Name = (string)Json["name"];
        foreach (string group in s_always)
            EsmPackageException.Need(Json.ContainsKey(group), "has no " + group);
        foreach (string[] row in s_rows)
            if (Json.ContainsKey(row[0])) m_arrays[row[0] + "." + row[1]] = ReadArray(row);
        ReadStiffening();
        ReadBinding();
        ReadDrawn();
        ReadFillings();
        CheckModel();
    }

    private static int Count(object value) {
        double number = (double)value;
        EsmPackageException.Need(number >= 0 && number <= int.MaxValue && number == Math.Floor(number), "has a count that is none");
        return (int)number;
    }
    private static int CountOr(Dictionary<string, object> holder, string key, int otherwise) {
        return holder.ContainsKey(key) ? Count(holder[key]) : otherwise;
    }
    private int CountOf(string name) {
        string[] parts = name.Split('.');
        return Count(((Dictionary<string, object>)Json[parts[0]])[parts[1]]);
    }

    private Dictionary<string, object> Element(string kind, object place) {
        var list = (List<object>)m_gltf[kind];
        EsmPackageException.Need(Count(place) < list.Count, "has nothing at one of its " + kind);
        return (Dictionary<string, object>)list[Count(place)];
    }

    /// <summary>Where a view begins, and how long it is.</summary>
    private int[] View(object place) {
        Dictionary<string, object> view = Element("bufferViews", place);
        long offset = CountOr(view, "byteOffset", 0), size = Count(view["byteLength"]);
        EsmPackageException.Need(Count(view["buffer"]) == 0 && !view.ContainsKey("byteStride"), "has a bufferView of another kind");
        EsmPackageException.Need(offset + size <= m_binary.Length, "is damaged: a bufferView reaches beyond the file's binary data");
        return new[] {(int)offset, (int)size};
    }

    /// <summary>Of an accessor. Count: how many elements it should have; below 0: any.</summary>
    private Array Numbers(object place, string type, long count) {
        Dictionary<string, object> accessor = Element("accessors", place);
        int found = Count(accessor["count"]), kind = Count(accessor["componentType"]), offset = CountOr(accessor, "byteOffset", 0);
        EsmPackageException.Need((string)accessor["type"] == type && (count < 0 || found == count), "has an accessor of another type or length");
        EsmPackageException.Need((kind == FloatType || kind == UnsignedType) && !accessor.ContainsKey("sparse"), "has an accessor of another kind");
        int[] view = View(accessor["bufferView"]);
        long numbers = (long)found * (type == "SCALAR" ? 1 : type[3] - '0');
        EsmPackageException.Need(offset % 4 == 0 && offset + 4 * numbers <= view[1], "is damaged: an accessor reaches beyond its bufferView");
        Array values = kind == FloatType ? (Array)new float[numbers] : new uint[numbers];
        Buffer.BlockCopy(m_binary, view[0] + offset, values, 0, (int)(4 * numbers));
        return values;
    }

    /// <summary>That no bit has flipped. In the place of the sums' own view, the last, stands that of the JSON.</summary>
    private void CheckSums(uint[] sums) {
        EsmPackageException.Need(Crc32(m_text, 0, m_text.Length) == sums[sums.Length - 1], "is damaged: its JSON does not have the check sum that it should");
        for (int i = 0; i + 1 < sums.Length; ++i) {
            int[] view = View((double)i);
            EsmPackageException.Need(Crc32(m_binary, view[0], view[1]) == sums[i], "is damaged: bufferViews/" + i + " does not have the check sum that it should");
        }
    }

    /// <summary>As zlib and PNG have it.</summary>
    private static uint Crc32(byte[] bytes, int begin, int size) {
        uint[] table = Enumerable.Range(0, 256).Select(start => {
            uint entry = (uint)start;
            for (int bit = 0; bit < 8; ++bit)
                entry = (entry & 1) != 0 ? entry >> 1 ^ 0xEDB88320 : entry >> 1;
            return entry;
        }).ToArray();
        uint sum = 0xFFFFFFFF;
        for (int i = begin; i < begin + size; ++i)
            sum = table[(sum ^ bytes[i]) & 255] ^ sum >> 8;
        return ~sum;
    }

    private Array ReadArray(string[] row) {
        long count = CountOf(row[2]), each = int.Parse(row[3]), size = row[4] == "VEC3" ? 3 : 1;
        bool isIndex = row[5] == "node" || row[5] == "vertex";
        if (count == 0) return isIndex ? (Array)new uint[0] : new float[0];
        Array values = Numbers(((Dictionary<string, object>)Json[row[0]])[row[1]], row[4], count * each / size);
        Check(values, row[5], row[0] + "." + row[1]);
        return values;
    }

    private void Check(Array values, string allowed, string name) {
        if (allowed == "node" || allowed == "vertex") {
            var indices = (uint[])values;
            long limit = CountOf(allowed == "node" ? "nodes.count" : "surface.vertexCount");
            EsmPackageException.Need(indices.All(index => index < limit), name + " names what the model does not have");
            return;
        }
        double least = allowed == "number" ? -Largest : allowed == "mass" ? 1 / Largest : allowed == "positive" ? double.Epsilon : 0;
        EsmPackageException.Need(((float[])values).All(value => value >= least && value <= Largest), name + " holds what cannot be");
    }

    private void ReadStiffening() {
        StiffeningStrain = double.PositiveInfinity;
        StiffeningFactor = 1;
        if (!Json.ContainsKey("stiffening")) return;
        var law = (Dictionary<string, object>)Json["stiffening"];
        StiffeningStrain = (double)law["strain"];
        StiffeningFactor = (double)law["factor"];
        EsmPackageException.Need(StiffeningStrain > 0 && StiffeningFactor > 0 && StiffeningStrain <= Largest && StiffeningFactor <= Largest,
                                 "has springs that stiffen by no law");
    }

    private void ReadBinding() {
        if (!Has("binding")) return;
        var binding = (Dictionary<string, object>)Json["binding"];
        int vertices = CountOf("surface.vertexCount");
        bool hasStarts = binding.ContainsKey("starts");
        uint[] starts = hasStarts ? (uint[])Numbers(binding["starts"], "SCALAR", vertices + 1)
                                  : Enumerable.Range(0, vertices + 1).Select(i => (uint)(3 * i)).ToArray();
        EsmPackageException.Need(starts[0] == 0, "binding.starts do not begin with 0");
        for (int i = 0; i < vertices; ++i)
            EsmPackageException.Need(starts[i] < starts[i + 1], "binding.starts do not rise");
        long all = starts[vertices];
        var shares = (float[])(hasStarts ? Numbers(binding["shares"], "SCALAR", all) : Numbers(binding["shares"], "VEC3", vertices));
        Array nodes = Numbers(binding["nodes"], "SCALAR", all);
        Check(nodes, "node", "binding.nodes");
        Check(shares, "number", "binding.shares");
        for (int i = 0; i < vertices; ++i) {
            double sum = 0;
            for (uint place = starts[i]; place < starts[i + 1]; ++place) {
                sum += shares[place];
                EsmPackageException.Need(Math.Abs(shares[place]) <= 4, "binding.shares hold what cannot be");
            }
            EsmPackageException.Need(Math.Abs(sum - 1) <= 1e-6, "the shares in vertex " + i + " are not one");
        }
        m_arrays["binding.starts"] = starts;
        m_arrays["binding.nodes"] = nodes;
        m_arrays["binding.shares"] = shares;
    }

    private void ReadDrawn() {
        Drawn = new List<Dictionary<string, Array>>();
        foreach (Dictionary<string, object> entry in (List<object>)Json["drawn"]) {
            var primitives = (List<object>)Element("meshes", entry["mesh"])["primitives"];
            EsmPackageException.Need(Count(entry["primitive"]) < primitives.Count, "draws a primitive that it has not");
            var primitive = (Dictionary<string, object>)primitives[Count(entry["primitive"])];
            var attributes = (Dictionary<string, object>)primitive["attributes"];
            var part = new Dictionary<string, Array>();
            foreach (string[] kind in new[] {new[] {"POSITION", "VEC3"}, new[] {"NORMAL", "VEC3"}, new[] {"TEXCOORD_0", "VEC2"}})
                if (attributes.ContainsKey(kind[0])) part[kind[0]] = (float[])Numbers(attributes[kind[0]], kind[1], -1);
            foreach (string key in new[] {"vertexNodes", "vertices", "triangles"})
                if (entry.ContainsKey(key)) part[key] = (uint[])Numbers(entry[key], "SCALAR", key == "triangles" ? -1 : part["POSITION"].Length / 3);
            Check(part["vertexNodes"], "node", "drawn.vertexNodes");
            if (part.ContainsKey("vertices")) Check(part["vertices"], "vertex", "drawn.vertices");
            if (primitive.ContainsKey("indices")) part["indices"] = (uint[])Numbers(primitive["indices"], "SCALAR", -1);
            Drawn.Add(part);
        }
        Pictures = new List<byte[]>();
        if (!m_gltf.ContainsKey("images")) return;
        foreach (Dictionary<string, object> image in (List<object>)m_gltf["images"]) {
            int[] view = View(image["bufferView"]);
            var bytes = new byte[view[1]];
            Buffer.BlockCopy(m_binary, view[0], bytes, 0, view[1]);
            Pictures.Add(bytes);
        }
    }

    private void ReadFillings() {
        Fillings = new List<KeyValuePair<int, double>>();
        if (!Has("fillings")) return;
        foreach (Dictionary<string, object> filling in (List<object>)Json["fillings"]) {
            var stiffness = (double)filling["stiffness"];
            EsmPackageException.Need(stiffness > 0 && stiffness <= Largest, "has a filling that cannot be");
            Fillings.Add(new KeyValuePair<int, double>(Count(filling["part"]), stiffness));
        }
    }

    private void CheckModel() {
        EsmPackageException.Need(NodeCount > 0, "has no nodes");
        foreach (string[] kind in new[] {new[] {"springs", "nodes", "2"}, new[] {"hinges", "nodes", "4"}, new[] {"binding", "lines", "2"}}) {
            uint[] nodes = Indices(kind[0], kind[1]);
            int size = int.Parse(kind[2]);
            for (int i = 0; i < nodes.Length; i += size)
                EsmPackageException.Need(nodes.Skip(i).Take(size).Distinct().Count() == size, "one of its " + kind[0] + " has a node twice");
        }
        uint[] fixedNodes = Indices("fixedNodes", "nodes");
        for (int i = 1; i < fixedNodes.Length; ++i)
            EsmPackageException.Need(fixedNodes[i - 1] < fixedNodes[i], "its fixed nodes are not in order");
        EsmPackageException.Need(Version >= 6 || (AreMeans("springConstant") && AreMeans("viscosity")), "its springs are not the mean of their nodes");
    }

    private double[] Means(string key) {
        float[] at = Floats("nodes", key);
        uint[] ends = Indices("springs", "nodes");
        return Enumerable.Range(0, ends.Length / 2).Select(i => ((double)at[ends[2 * i]] + at[ends[2 * i + 1]]) / 2).ToArray();
    }
    private bool AreMeans(string key) {
        float[] at = Floats("nodes", key), own = Floats("springs", key);
        uint[] ends = Indices("springs", "nodes");
        double[] means = Means(key);
        return Enumerable.Range(0, own.Length).All(i => Math.Abs(own[i] - means[i]) <= 1e-6 * Math.Max(at[ends[2 * i]], at[ends[2 * i + 1]]));
    }

    /// <summary>Of springs. Where all are the mean of their nodes', that mean, not rounded as the file has it.</summary>
    public double[] SpringValues(string key) {
        bool areRounded = AreMeans("springConstant") && AreMeans("viscosity");
        return areRounded ? Means(key) : Floats("springs", key).Select(value => (double)value).ToArray();
    }

    /// <summary>Three nodes each: what instruments touch, and fluid fills.</summary>
    public uint[] SimulatedTriangles() {
        if (Has("lattice")) return Indices("lattice", "triangles");
        if (Has("binding")) return Indices("binding", "triangles");
        uint[] nodes = Indices("surface", "vertexNodes");
        return Indices("surface", "triangles").Select(vertex => nodes[vertex]).ToArray();
    }

    /// <summary>x, y, z of every vertex of the surface, m, where nodes at these positions carry it.</summary>
    public double[] Carried(double[] positions) {
        float[] rest = Floats("nodes", "restPosition"), vertices = Floats("surface", "restPosition");
        var places = vertices.Select(number => (double)number).ToArray();
        if (!Has("binding")) {
            uint[] carriers = Indices("surface", "vertexNodes");
            for (int i = 0; i < places.Length; ++i)
                places[i] += positions[3 * carriers[i / 3] + i % 3] - rest[3 * carriers[i / 3] + i % 3];
            return places;
        }
        uint[] starts = Indices("binding", "starts"), nodes = Indices("binding", "nodes");
        float[] shares = Floats("binding", "shares");
        double[][] turns = Turns(positions);
        for (int vertex = 0; vertex + 1 < starts.Length; ++vertex)
            for (uint k = starts[vertex]; k < starts[vertex + 1]; ++k) {
                EsmVector p0 = EsmVector.At(rest, nodes[k]), arm = EsmVector.At(vertices, (uint)vertex) - p0;
                double[] turn = turns[nodes[k]];
                EsmVector turned = turn == null ? arm : EsmVector.Times(turn, arm);
                (shares[k] * (EsmVector.At(positions, nodes[k]) - p0 + turned - arm)).AddTo(places, (uint)vertex);
            }
        return places;
    }

    /// <summary>For every node the matrix G of the specification, by rows; null where it is 1.</summary>
    private double[][] Turns(double[] positions) {
        float[] rest = Floats("nodes", "restPosition");
        var sums = new double[NodeCount][];
        var weights = new double[NodeCount];
        Action<uint, double[], double> add = (node, matrix, weight) => {
            weights[node] += weight;
            sums[node] = sums[node] == null ? matrix : sums[node].Zip(matrix, (a, b) => a + b).ToArray();
        };
        uint[] corners = Indices("binding", "triangles"), lines = Indices("binding", "lines");
        for (int i = 0; i < corners.Length; i += 3) {
            EsmVector first = EsmVector.At(rest, corners[i]), now = EsmVector.At(positions, corners[i]);
            EsmVector a0 = EsmVector.At(rest, corners[i + 1]) - first, b0 = EsmVector.At(rest, corners[i + 2]) - first;
            EsmVector a = EsmVector.At(positions, corners[i + 1]) - now, b = EsmVector.At(positions, corners[i + 2]) - now;
            EsmVector n0 = EsmVector.Cross(a0, b0), n = EsmVector.Cross(a, b);
            double area = n0.Length, areaNow = n.Length;
            if (area == 0) continue;
            n0 = 1 / area * n0;
            n = (areaNow > 0 ? area / areaNow : 0) * n;
            double[] part = EsmVector.Outer(a, EsmVector.Cross(b0, n0));
            double[][] others = {EsmVector.Outer(b, EsmVector.Cross(n0, a0)), EsmVector.Outer(n, n0)};
            foreach (double[] other in others)
                part = part.Zip(other, (x, y) => x + y).ToArray();
            for (int corner = 0; corner < 3; ++corner)
                add(corners[i + corner], part, area);
        }
        for (int i = 0; i < lines.Length; i += 2) {
            double[] turn = EsmVector.SmallestRotation(EsmVector.At(rest, lines[i + 1]) - EsmVector.At(rest, lines[i]),
                                                       EsmVector.At(positions, lines[i + 1]) - EsmVector.At(positions, lines[i]));
            add(lines[i], turn, 1);
            add(lines[i + 1], turn, 1);
        }
        return sums.Select((sum, node) => sum == null ? null : sum.Select(x => x / weights[node]).ToArray()).ToArray();
    }
}

/// <summary>A package that moves, from rest, by semi-implicit Euler: for light tissue and short steps.</summary>
public sealed class EsmMotion {
    /// <summary>x, y, z of every node: m, and m/s.</summary>
    public double[] Positions { get; private set; }
    public double[] Velocities { get; private set; }
    public double Time { get; private set; }
    public EsmVector Gravity;                                                               // m/s²
    public readonly Dictionary<uint, double[]> Forces = new Dictionary<uint, double[]>();   // N, by node
    public readonly Dictionary<uint, double[]> Led = new Dictionary<uint, double[]>();      // m, by node: the place at the step's end

    private readonly EsmPackage m_package;
    private readonly double[] m_constants, m_viscosities;
    private readonly float[] m_rest, m_masses, m_lengths;
    private readonly uint[] m_ends;
    private readonly HashSet<uint> m_fixed;
    private readonly List<EsmHinge> m_hinges = new List<EsmHinge>();

    public EsmMotion(EsmPackage package) {
        EsmPackageException.Need(package.Fillings.Count == 0, "this reader does not step parts that are filled with fluid");
        m_package = package;
        m_rest = package.Floats("nodes", "restPosition");
        m_masses = package.Floats("nodes", "mass");
        m_ends = package.Indices("springs", "nodes");
        m_lengths = package.Floats("springs", "restLength");
        m_constants = package.SpringValues("springConstant");
        m_viscosities = package.SpringValues("viscosity");
        m_fixed = new HashSet<uint>(package.Indices("fixedNodes", "nodes"));
        uint[] hinges = package.Indices("hinges", "nodes");
        for (int i = 0; i < hinges.Length; i += 4)
            m_hinges.Add(new EsmHinge(hinges.Skip(i).Take(4).ToArray(), package.Floats("hinges", "stiffness")[i / 4],
                                      package.Floats("hinges", "viscosity")[i / 4], m_rest));
        Reset();
    }

    public void Reset() {
        Positions = m_rest.Select(number => (double)number).ToArray();
        Velocities = new double[Positions.Length];
        Time = 0;
    }

    /// <summary>Moves on by so many seconds.</summary>
    public void Step(double h) {
        foreach (var led in Led)
            for (int axis = 0; axis < 3; ++axis)
                Velocities[3 * led.Key + axis] = (led.Value[axis] - Positions[3 * led.Key + axis]) / h;
        double[] forces = AllForces();
        for (uint node = 0; node < m_masses.Length; ++node) {
            if (m_fixed.Contains(node) || Led.ContainsKey(node)) continue;
            EsmVector acceleration = 1.0 / m_masses[node] * EsmVector.At(forces, node) + Gravity;
            EsmVector change = h * acceleration;
            change.AddTo(Velocities, node);
        }
        for (int i = 0; i < Positions.Length; ++i)
            Positions[i] += h * Velocities[i];
        foreach (var led in Led)
            Array.Copy(led.Value, 0, Positions, 3 * led.Key, 3);
        Time += h;
    }

    private double[] AllForces() {
        var forces = new double[Positions.Length];
        for (int i = 0; i < m_lengths.Length; ++i)
            AddSpring(i, forces);
        uint[] tethered = m_package.Indices("tethers", "nodes");
        float[] constants = m_package.Floats("tethers", "springConstant"), viscosities = m_package.Floats("tethers", "viscosity");
        for (int i = 0; i < tethered.Length; ++i) {
            EsmVector away = EsmVector.At(Positions, tethered[i]) - EsmVector.At(m_rest, tethered[i]);
            (-constants[i] * away - viscosities[i] * EsmVector.At(Velocities, tethered[i])).AddTo(forces, tethered[i]);
        }
        foreach (EsmHinge hinge in m_hinges)
            hinge.AddForces(Positions, Velocities, forces);
        foreach (var force in Forces)
            new EsmVector(force.Value[0], force.Value[1], force.Value[2]).AddTo(forces, force.Key);
        return forces;
    }

    private void AddSpring(int spring, double[] forces) {
        uint first = m_ends[2 * spring], second = m_ends[2 * spring + 1];
        EsmVector between = EsmVector.At(Positions, first) - EsmVector.At(Positions, second);
        EsmVector approach = EsmVector.At(Velocities, first) - EsmVector.At(Velocities, second);
        double length = between.Length, rest = m_lengths[spring], pull = 0, stretched = (1 + m_package.StiffeningStrain) * rest;
        if (length > 0) pull = m_constants[spring] * (rest / length - 1);
        if (length > stretched) pull -= (m_package.StiffeningFactor - 1) * m_constants[spring] * (1 - stretched / length);
        EsmVector force = pull * between - m_viscosities[spring] * approach;
        force.AddTo(forces, first);
        (-1 * force).AddTo(forces, second);
    }
}

/// <summary>Two triangles that resist being bent about their edge.</summary>
internal sealed class EsmHinge {
    private readonly uint[] m_nodes;
    private readonly double[] m_weights;
    private readonly double m_curvature, m_constant, m_damping;

    public EsmHinge(uint[] nodes, double stiffness, double viscosity, float[] rest) {
        EsmVector[] p = nodes.Select(node => EsmVector.At(rest, node)).ToArray();
        EsmVector u = p[1] - p[0], v = p[3] - p[2], r = p[2] - p[0], n = EsmVector.Cross(u, v);
        double squared = EsmVector.Dot(n, n);
        double along = EsmVector.Dot(EsmVector.Cross(r, v), n) / squared, across = EsmVector.Dot(EsmVector.Cross(r, u), n) / squared;
        m_nodes = nodes;
        m_weights = new[] {along - 1, -along, 1 - across, across};
        m_curvature = EsmVector.Dot(r, n) / squared;
        EsmVector t = EsmVector.Cross(1 / u.Length * u, r), opening = m_weights[2] * t + m_curvature * EsmVector.Cross(u, t);
        EsmPackageException.Need(squared > 0 && opening.Length > 0, "a hinge has a triangle without area");
        m_constant = stiffness / EsmVector.Dot(opening, opening);
        m_damping = viscosity / EsmVector.Dot(opening, opening);
    }

    private EsmVector Sum(double[] of) {
        EsmVector first = EsmVector.At(of, m_nodes[0]), sum = new EsmVector();
        for (int i = 1; i < 4; ++i)
            sum += m_weights[i] * (EsmVector.At(of, m_nodes[i]) - first);
        return sum;
    }

    public void AddForces(double[] positions, double[] velocities, double[] forces) {
        EsmVector[] p = m_nodes.Select(node => EsmVector.At(positions, node)).ToArray();
        EsmVector u = p[1] - p[0], v = p[3] - p[2];
        EsmVector f = -m_constant * (Sum(positions) - m_curvature * EsmVector.Cross(u, v)), resistance = m_damping * Sum(velocities);
        EsmVector g = -m_curvature * EsmVector.Cross(v, f), h = -m_curvature * EsmVector.Cross(f, u);
        var parts = new[] {new EsmVector(), m_weights[1] * f + g, m_weights[2] * f - h, m_weights[3] * f + h};
        parts[0] = -1 * (parts[1] + parts[2] + parts[3]);
        for (int i = 0; i < 4; ++i)
            (parts[i] - m_weights[i] * resistance).AddTo(forces, m_nodes[i]);
    }
}

public struct EsmVector {
    public double X, Y, Z;

    public EsmVector(double x, double y, double z) { X = x; Y = y; Z = z; }
    public static EsmVector At(double[] values, uint place) { return new EsmVector(values[3 * place], values[3 * place + 1], values[3 * place + 2]); }
    public static EsmVector At(float[] values, uint place) { return new EsmVector(values[3 * place], values[3 * place + 1], values[3 * place + 2]); }
    public static EsmVector operator +(EsmVector a, EsmVector b) { return new EsmVector(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
    public static EsmVector operator -(EsmVector a, EsmVector b) { return new EsmVector(a.X - b.X, a.Y - b.Y, a.Z - b.Z); }
    public static EsmVector operator *(double number, EsmVector a) { return new EsmVector(number * a.X, number * a.Y, number * a.Z); }
    public static double Dot(EsmVector a, EsmVector b) { return a.X * b.X + a.Y * b.Y + a.Z * b.Z; }
    public static EsmVector Cross(EsmVector a, EsmVector b) { return new EsmVector(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X); }
    public double Length { get { return Math.Sqrt(Dot(this, this)); } }

    public void AddTo(double[] values, uint place) {
        values[3 * place] += X;
        values[3 * place + 1] += Y;
        values[3 * place + 2] += Z;
    }

    /// <summary>Matrices are nine numbers, by rows.</summary>
    public static double[] Outer(EsmVector a, EsmVector b) {
        return new[] {a.X * b.X, a.X * b.Y, a.X * b.Z, a.Y * b.X, a.Y * b.Y, a.Y * b.Z, a.Z * b.X, a.Z * b.Y, a.Z * b.Z};
    }
    public static EsmVector Times(double[] m, EsmVector a) {
        return new EsmVector(m[0] * a.X + m[1] * a.Y + m[2] * a.Z, m[3] * a.X + m[4] * a.Y + m[5] * a.Z, m[6] * a.X + m[7] * a.Y + m[8] * a.Z);
    }

    /// <summary>Takes the direction of the one to that of the other.</summary>
    public static double[] SmallestRotation(EsmVector first, EsmVector second) {
        var unit = new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1};
        if (first.Length == 0 || second.Length == 0) return unit;
        EsmVector a = 1 / first.Length * first, b = 1 / second.Length * second, axis = Cross(a, b);
        double cosine = Dot(a, b);
        if (cosine <= -1 + 1e-12) return unit;
        double[] cross = {0, -axis.Z, axis.Y, axis.Z, 0, -axis.X, -axis.Y, axis.X, 0}, outer = Outer(axis, axis);
        for (int i = 0; i < 9; ++i)
            unit[i] += cross[i] + (outer[i] - (i % 4 == 0 ? Dot(axis, axis) : 0)) / (1 + cosine);
        return unit;
    }
}

/// <summary>What of JSON a package needs, read strictly.</summary>
internal sealed class EsmJson {
    private const int Deepest = 100;
    private readonly string m_text;
    private int m_place, m_depth;

    public EsmJson(string text) { m_text = text; }

    public Dictionary<string, object> Object() {
        var found = Value() as Dictionary<string, object>;
        EsmPackageException.Need(found != null && Next() == '\0', "holds JSON that describes nothing");
        return found;
    }

    /// <summary>The next character that is no blank, or 0 at the end.</summary>
    private char Next() {
        while (m_place < m_text.Length && " \t\r\n".IndexOf(m_text[m_place]) >= 0)
            ++m_place;
        return m_place < m_text.Length ? m_text[m_place] : '\0';
    }
    private bool Takes(char wanted) {
        if (Next() != wanted) return false;
        ++m_place;
        return true;
    }
    private void Need(bool condition) { EsmPackageException.Need(condition, "holds JSON that is damaged at character " + m_place); }

    private object Value() {
        Need(++m_depth < Deepest);
        char first = Next();
        object value = first == '{' ? Members() : first == '[' ? Elements() : first == '"' ? Text() : first == 't' ? Word("true", true)
                     : first == 'f' ? Word("false", false) : first == 'n' ? Word("null", null) : Number();
        --m_depth;
        return value;
    }

    private object Members() {
        var members = new Dictionary<string, object>();
        for (Takes('{'); !Takes('}');) {
            Need(members.Count == 0 || Takes(','));
            Next();
            string key = Text();
            Need(Takes(':'));
            members[key] = Value();
        }
        return members;
    }

    private object Elements() {
        var elements = new List<object>();
        for (Takes('['); !Takes(']');) {
            Need(elements.Count == 0 || Takes(','));
            elements.Add(Value());
        }
        return elements;
    }

    private string Text() {
        Need(Takes('"'));
        var text = new StringBuilder();
        for (;;) {
            Need(m_place < m_text.Length);
            char letter = m_text[m_place++];
            if (letter == '"') return text.ToString();
            text.Append(letter == '\\' ? Escaped() : letter);
        }
    }

    private char Escaped() {
        Need(m_place + 5 <= m_text.Length);
        char letter = m_text[m_place++];
        int known = "\"\\/bfnrt".IndexOf(letter);
        if (known >= 0) return "\"\\/\b\f\n\r\t"[known];
        Need(letter == 'u');
        m_place += 4;
        return (char)int.Parse(m_text.Substring(m_place - 4, 4), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture);
    }

    private object Word(string word, object value) {
        Need(string.CompareOrdinal(m_text, m_place, word, 0, word.Length) == 0);
        m_place += word.Length;
        return value;
    }

    private object Number() {
        int begin = m_place;
        while (m_place < m_text.Length && "+-.0123456789eE".IndexOf(m_text[m_place]) >= 0)
            ++m_place;
        double number;
        Need(double.TryParse(m_text.Substring(begin, m_place - begin), NumberStyles.Float, CultureInfo.InvariantCulture, out number));
        return number;
    }
}

#if ESM_PACKAGE_PROGRAM
/// <summary>ORGAN.glb [STEPS SECONDS NODE FX FY FZ]: says what it holds, or where a force on a node moved it and its surface.</summary>
internal static class EsmPackageProgram {
    private static void Print(IEnumerable<double> numbers) {
        Console.WriteLine(string.Join(" ", numbers.Select(number => number.ToString("R", CultureInfo.InvariantCulture))));
    }

    private static int Main(string[] arguments) {
        try {
            EsmPackage package = EsmPackage.Read(arguments[0]);
            Console.WriteLine("{0} nodes, {1} springs, {2} hinges", package.NodeCount, package.Floats("springs", "restLength").Length,
                              package.Floats("hinges", "stiffness").Length);
            if (arguments.Length < 7) return 0;
            double[] numbers = arguments.Skip(1).Select(text => double.Parse(text, CultureInfo.InvariantCulture)).ToArray();
            var motion = new EsmMotion(package);
            motion.Forces[(uint)numbers[2]] = numbers.Skip(3).ToArray();
            for (int step = 0; step < numbers[0]; ++step)
                motion.Step(numbers[1]);
            Print(motion.Positions);
            Print(package.Carried(motion.Positions));
            return 0;
        } catch (Exception problem) when (problem is EsmPackageException || problem is IOException || problem is UnauthorizedAccessException) {
            Console.Error.WriteLine(arguments[0] + ": " + problem.Message);
            return 1;
        }
    }
}
#endif
