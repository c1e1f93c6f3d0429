package starlogo.models.scene
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.animation.JointInfluences;
    import starlogo.models.building.ModelData;
    import starlogo.models.files.refuseModelIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * An instance of a mesh at a node of a scene. It moves the points by morphs and skins, and adds them and the triangles to a model.
     *
     * @private
     */
    public final class MeshInstance
    {
        private static const POINTS_PER_STEP:int = 3000;
        private static const SKINNED_PER_STEP:int = 1000;
        private static const TRIANGLES_PER_STEP:int = 5000;

        /** The mesh. Read only. */
        public var mesh:SceneMesh;

        /**
         * Moves the points by morphs and skins: <code>function(points:Vector.&lt;Number&gt;):Steps</code>, called when the mesh is read. The steps change the
         * points by <code>morphing()</code> and <code>skinning()</code>. Null for none.
         */
        public var deforming:Function = null;

        private var _scene:Scene;
        private var _node:int;
        private var _place:Object;
        private var _name:String;
        private var _labelOf:Function;

        // what takes the moved points to the scene, and whether the mesh is mirrored there; null if the node does
        private var _transform:AffineTransform;
        private var _isMirror:Boolean;

        /**
         * @param scene the scene
         * @param node the index of the node; -1 for none
         * @param mesh the mesh; all its instances share it
         * @param place the instance's place in the file, for errors
         * @param name the name of the model's mesh that it becomes; null for none
         * @param labelOf <code>function(material:String, materials:TriangleLabels):int</code>; returns the label of a primitive's material
         */
        public function MeshInstance(scene:Scene, node:int, mesh:SceneMesh, place:Object, name:String, labelOf:Function)
        {
            _scene = scene;
            _node = node;
            this.mesh = mesh;
            _place = place;
            _name = name;
            _labelOf = labelOf;
        }

        /** The steps that read the mesh, if that was not done yet, and add it to a model in the scene's present pose. */
        public function adding(data:ModelData):Steps
        {
            var points:Vector.<Number>;
            _transform = null;
            return new StepSequence().add(mesh).begin(function():Steps
                {
                    points = deforming == null ? mesh.points : mesh.points.slice();
                    return deforming == null ? null : deforming(points);
                }).begin(function():Steps
                {
                    return placing(points, data);
                });
        }

        /**
         * Says where the moved points are in the scene, if the node does not.
         *
         * @param transform takes them to the scene
         * @param isMirror whether the mesh is mirrored there
         */
        public function putAt(transform:AffineTransform, isMirror:Boolean):void
        {
            _transform = transform;
            _isMirror = isMirror;
        }

        /**
         * The steps that move some points a part of the way to the points of a morph target.
         *
         * @param points all points of the instance
         * @param first the index of the first point that moves
         * @param weight the part of the way
         * @param target the points of the target
         * @param base where the way begins; null if the target has the ways themselves
         */
        public function morphing(points:Vector.<Number>, first:int, weight:Number, target:Vector.<Number>, base:Vector.<Number>):Steps
        {
            _scene.budget.spendNumbers(target.length, _place);
            return new StepSequence().slices(target.length, 3 * POINTS_PER_STEP, function(from:int, end:int):void
                {
                    for (var i:int = from; i < end; i++)
                    {
                        points[int(3 * first + i)] += weight * (base == null ? target[i] : target[i] - base[i]);
                    }
                });
        }

        /**
         * The steps that move points to where joints put them in the scene.
         *
         * @param points all points of the instance
         * @param influences says which joints each of these points follows
         * @param jointMatrices what each joint does to points
         * @param skin the skin's place in the file, for errors
         */
        public function skinning(points:Vector.<Number>, influences:JointInfluences, jointMatrices:Vector.<AffineTransform>, skin:Object):Steps
        {
            _scene.budget.spendNumbers(2 * influences.joints.length, skin);
            putAt(new AffineTransform(), jointMatrices[0].isMirror);
            return new StepSequence().slices(points.length / 3, SKINNED_PER_STEP, function(first:int, end:int):void
                {
                    refuseModelIf(!influences.skinPoints(points, jointMatrices, first, end), _scene.budget.modelName,
                            "it moves points too far: their coordinates are not finite numbers", skin);
                });
        }

        // The steps that add points and the triangles. If the points are mirrored, the triangles' corner order is reversed.
        private function placing(points:Vector.<Number>, data:ModelData):Steps
        {
            var transform:AffineTransform = _transform || _scene.transformOf(_node);
            var isMirror:Boolean = _transform == null ? transform.isMirror : _isMirror;
            var firstVertex:int = data.vertices.length / 3;
            var firstTriangle:int = data.triangles.length / 3;
            var vertexCount:int = points.length / 3;
            var triangleCount:int = mesh.triangles.length / 3;
            _scene.budget.checkMeshSize(firstVertex + vertexCount, firstTriangle + triangleCount, _place);
            if (triangleCount > 0)
            {
                addLabels(data, firstTriangle);
            }
            return new StepSequence().slices(vertexCount, POINTS_PER_STEP, function(first:int, end:int):void
                {
                    refuseModelIf(!transform.transformPoints(points, first, end, data.vertices, firstVertex + first), data.name,
                            "its vertices are not finite numbers, or are too large at its place", _place);
                }).slices(triangleCount, TRIANGLES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = 3 * first; i < 3 * end; i += 3)
                    {
                        var b:int = firstVertex + mesh.triangles[int(i + 1)];
                        var c:int = firstVertex + mesh.triangles[int(i + 2)];
                        data.triangles.push(firstVertex + mesh.triangles[i], isMirror ? c : b, isMirror ? b : c);
                    }
                });
        }

        private function addLabels(data:ModelData, firstTriangle:int):void
        {
            data.meshes.beginRun(data.meshes.addLabel(_name), firstTriangle);
            for (var i:int = 0; i < mesh.materials.length; i++)
            {
                data.materials.beginRun(_labelOf(mesh.materials[i], data.materials), firstTriangle + mesh.firstTriangles[i]);
            }
        }
    }
}
