// This room has models, and what reads them from files. The ModelReader of each format fills a ModelData, and then a ModelBuilder brings the vertices to
// their place and scale. building/ has these three; files/, text/ and polygons/ serve the readers. A COLLADA or glTF file is a Scene of nodes and meshes (scene/),
// which animation/ moves. cooked/ is the engine's own format: CookedFile is the whole file; CookedReader and CookedWriter have the model's
// section; libraries/cooked and CollisionDataBuilder have the others. A ModelLoader does the same in steps while a game runs. Read this file first, then
// building/ModelBuilder, obj/ObjReader, scene/Scene, ModelLoader, loading/ModelLoad.
package starlogo.models
{
    import starlogo.engine;
    import starlogo.geometry.vertices.VertexBounds;
    import starlogo.geometry.vertices.vertexProblem;
    import starlogo.models.building.ModelBuilder;
    import starlogo.models.building.ModelData;
    import starlogo.models.building.TriangleLabels;
    import starlogo.models.files.refuseModelIf;

    use namespace engine;

    /**
     * A shape that agents can have: a name, vertices and, if known, triangles.
     *
     * <p>The vertices are normalised: <code>FOOTPRINT</code>, <code>VOLUME</code> and <code>AS_GIVEN</code> say how. To place an agent, its
     * model is scaled by the agent's size, turned about the model's origin and moved to the agent's position.</p>
     *
     * <p>Its coordinates are finite, and its triangles use only existing vertices. Triangles without area are kept. Only
     * <code>pose()</code> changes a model's shape. <code>setMaterials()</code> and <code>setMeshes()</code> change what hits tell.</p>
     *
     * <p>A triangle may have a material and a mesh, each a number that may have a name. Files say them: an OBJ file's <code>usemtl</code>, and
     * <code>o</code> or <code>g</code>; a COLLADA document's materials, and the nodes that place its geometries; a glTF file's materials, and
     * its nodes with meshes. Hits of rays and casts tell them.</p>
     */
    public class Model
    {
        /**
         * The default scaling, from the thesis (§2.2). The model is centred on the origin in x and y, its lowest vertex is at z = 0, and
         * the larger of its x and y extents is 1. Its height may be more than 1. If the x and y extents are both less than a millionth of
         * the z extent, the model is a vertical line and its z extent becomes 1. A single point is only moved to the origin. Of a
         * ModelTransform only the rotation and a non-uniform or negative scale have an effect.
         */
        public static const FOOTPRINT:String = "footprint";

        /**
         * The scaling of the StarLogo Nova client of 2017. The model is centred, and divided by the cube root of its box's volume; a side
         * of length 0 counts as 1. Then it is turned by the ModelTransform, and centred and divided again. Then it is multiplied by the
         * transform's factors, its lowest vertex is put at z = 0, and the transform moves it.
         */
        public static const VOLUME:String = "volume";

        /**
         * No scaling, for vertices that are already in the agent's unit and place. Their origin is the model's: it need not be the lowest
         * point, and the agent's place is where it is. A ModelTransform turns, scales and moves them. A COLLADA
         * document says how long its unit is: without a ModelTransform its vertices come in metres, a metre for a patch.
         */
        public static const AS_GIVEN:String = "as given";

        /**
         * The scalings. Cooked files store their index here.
         *
         * @private
         */
        engine static const SCALINGS:Vector.<String> = new <String>[FOOTPRINT, VOLUME, AS_GIVEN];

        /** @private How often it was posed. Read only. */
        engine var poseCount:int = 0;

        private var _data:ModelData;

        // The functions that are called after each pose; and the vertices of the next pose until they are checked, null before the first.
        private var _listeners:Vector.<Function> = new Vector.<Function>();
        private var _posed:Vector.<Number> = null;

        /**
         * Copies and normalises a shape.
         *
         * @param name what agents call the shape, not empty
         * @param vertices x, y, z, x, y, z, ... of at least one vertex, z up, in any unit; is not changed
         * @param triangles three vertex indices for each triangle (0 is the first vertex); null or empty if only vertices are known; is not
         * changed
         * @param scaling <code>FOOTPRINT</code>, <code>VOLUME</code> or <code>AS_GIVEN</code>
         * @param data for the engine alone: what a ModelBuilder has built, in place of the other arguments
         * @throws ModelError if the name is empty, if there is no vertex, if a coordinate is missing, not finite or so large that the
         * model's extent is not finite, if an index names no vertex, or if the scaling is unknown
         * @throws ArgumentError in JavaScript, if an index is no integer from 0 to 4294967295. In a Vector all indices are such integers
         */
        public function Model(name:String, vertices:Vector.<Number>, triangles:Vector.<uint> = null, scaling:String = FOOTPRINT, data:ModelData = null)
        {
            _data = data || ModelBuilder.dataOf(name, vertices, triangles, scaling);
        }

        /** The model's place and scale in its source, for a renderer that draws the source. Shared with the model. */
        public function get source():SourceFrame
        {
            return _data.source;
        }

        /** The name by which agents select the shape. */
        public function get name():String
        {
            return _data.name;
        }

        /**
         * The normalised vertices: x, y, z, x, y, z, ... This is the model's own vector: do not change it. A pose writes its vertices into
         * the same vector.
         */
        public function get vertices():Vector.<Number>
        {
            return _data.vertices;
        }

        /** Three vertex indices per triangle, or null if only vertices are known. This is the model's own vector: do not change it. */
        public function get triangles():Vector.<uint>
        {
            return _data.triangles;
        }

        /** The number of each triangle's material, -1 for none; null if no triangle has one. This is the model's own vector: do not change it. */
        public function get materials():Vector.<int>
        {
            return _data.materials.labels;
        }

        /** The name of each material, by its number; null for one without a name. Null if there are no materials or no names. Do not change it. */
        public function get materialNames():Vector.<String>
        {
            return _data.materials.names;
        }

        /** The number of the mesh that each triangle belongs to, -1 for none; null if the model has no meshes. Do not change it. */
        public function get meshes():Vector.<int>
        {
            return _data.meshes.labels;
        }

        /** The name of each mesh, by its number; null for one without a name. Null if there are no meshes or no names. Do not change it. */
        public function get meshNames():Vector.<String>
        {
            return _data.meshes.names;
        }

        /** Its name and size, as text. */
        public function toString():String
        {
            return "model \"" + name + "\" (" + vertices.length / 3 + " vertices, " + triangleCount + " triangles)";
        }

        /**
         * Gives the triangles materials. This changes no collision. Hits tell them from then on.
         *
         * @param numbers the number of each triangle's material, -1 for none; copied. Null removes the materials
         * @param names the name of each material, by its number, null for a material without a name; copied. Null if they have no names
         * @throws ModelError if there is not one number for each triangle, or if a number is less than -1 or has no name in the names
         */
        public function setMaterials(numbers:Vector.<int> = null, names:Vector.<String> = null):void
        {
            _data.materials = labelsOf("materials", numbers, names);
        }

        /**
         * Says which mesh each triangle belongs to. This changes no collision. Hits tell them from then on.
         *
         * @param numbers the number of each triangle's mesh, -1 for none; copied. Null removes the meshes
         * @param names the name of each mesh, by its number, null for a mesh without a name; copied. Null if they have no names
         * @throws ModelError if there is not one number for each triangle, or if a number is less than -1 or has no name in the names
         */
        public function setMeshes(numbers:Vector.<int> = null, names:Vector.<String> = null):void
        {
            _data.meshes = labelsOf("meshes", numbers, names);
        }

        /**
         * Moves the vertices to new places. The triangles stay the same ones. For figures whose joints move, call it once a frame, before
         * <code>Collision.update()</code> and <code>AgentQueries.update()</code>.
         *
         * <p>The vertices are given in the coordinates of the source, as they were for the constructor: see <code>SourceFrame</code>. The
         * model's scale and origin stay those of its first vertices, so a figure that stretches its arms becomes wider than 1. The first
         * vertices themselves give the first shape again, but for rounding.</p>
         *
         * <p>All agents with the model have the new shape from the next <code>update()</code> on, in each GreatLand to which the model was
         * added. <code>areColliding()</code> sees it at once. Hierarchies keep their division and get new boxes. Exact colliders test the new
         * triangles. Bounding structures stay as they are, because fitting them takes much longer. But a hull that nobody has asked for yet
         * is found around the pose when it is first needed. To fit all to the pose, call
         * <code>greatLand.boundingStructures.add(model.name, model.vertices)</code>. Until then colliders that use structures have the old
         * ones. The order of the vertices must not change. A pose that is very different from the first one makes tests slower, but not
         * wrong.</p>
         *
         * <p>If it throws, nothing has changed. Cost: linear in the numbers of vertices and triangles, a small part of the time in which the
         * hierarchy is built. It allocates a few records. What is inside of the surface is prepared again when it is next
         * needed, which takes longer.</p>
         *
         * @param vertices x, y, z of each vertex, in the order of the model's vertices; is neither kept nor changed
         * @throws ArgumentError if these are not as many coordinates as the model has, if one is not finite, or if one is larger than 1e60 in
         * the model; also if the first vertices were less than 1e-308 apart and were scaled: no pose fits them
         */
        public function pose(vertices:Vector.<Number>):void
        {
            var own:Vector.<Number> = _data.vertices;
            var beginning:String = "model \"" + name + "\": ";
            if (vertices == null || vertices.length != own.length)
            {
                throw new ArgumentError(beginning + "a pose needs its " + own.length / 3 + " vertices with three coordinates each, not "
                        + (vertices == null ? "null" : vertices.length + " numbers"));
            }
            _posed ||= new Vector.<Number>(own.length, true);
            source.toModel(vertices, _posed);
            var bounds:VertexBounds = VertexBounds.of(_posed);
            var problem:String = bounds.areFinite ? null : vertexProblem(vertices) || vertexProblem(_posed);
            if (problem != null)
            {
                throw new ArgumentError(beginning + problem);
            }
            VertexBounds.requireWithin(bounds.largest, beginning);
            for (var i:int = 0; i < _posed.length; i++)
            {
                own[i] = _posed[i];
            }
            _data.cooked = null;
            poseCount++;
            for each (var listener:Function in _listeners)
            {
                listener();
            }
        }

        /** @private What the model is made of. */
        engine final function get data():ModelData
        {
            return _data;
        }

        /**
         * Tells a listener about each pose from now on.
         *
         * @param listener <code>function():void</code>, called when the vertices are at their new places; must not throw
         *
         * @private
         */
        engine final function addListener(listener:Function):void
        {
            _listeners.push(listener);
        }

        /**
         * Ends what addListener began. A listener that is unknown is ignored.
         *
         * @private
         */
        engine final function removeListener(listener:Function):void
        {
            var index:int = _listeners.indexOf(listener);
            if (index >= 0)
            {
                _listeners.splice(index, 1);
            }
        }

        private function get triangleCount():int
        {
            return triangles == null ? 0 : triangles.length / 3;
        }

        private function labelsOf(what:String, numbers:Vector.<int>, names:Vector.<String>):TriangleLabels
        {
            var labels:TriangleLabels = new TriangleLabels(names == null ? null : names.slice());
            var count:int = triangleCount;
            if (numbers != null)
            {
                refuseModelIf(numbers.length != count, name, numbers.length + " numbers of " + what + " for " + count + " triangles");
                for (var i:int = 0; i < count; i++)
                {
                    if (numbers[i] < -1 || names != null && numbers[i] >= names.length)
                    {
                        throw new ModelError(name, "", (numbers[i] < -1 ? "a number less than -1: " + numbers[i] + " among its "
                                    : "no name for number " + numbers[i] + " of its ") + what);
                    }
                    labels.beginRun(numbers[i], i);
                }
            }
            labels.seal(count);
            return labels;
        }
    }
}
