package starlogo.models.scene
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.building.ModelData;
    import starlogo.models.building.reversingWinding;
    import starlogo.models.files.FileBudget;
    import starlogo.models.files.refuseModelIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * An instance of a mesh at a node of a scene, which may be deformed by morphs and skins.
     *
     * @private
     */
    public final class MeshInstance
    {
        private static const POINTS_PER_STEP:int = 3000;

        /** The mesh. Read only. */
        public var mesh:SceneMesh;

        /** The morphs and skins: <code>function(deformed:DeformedPoints):Steps</code>; returns the steps that move the points. Null for none. */
        public var deforming:Function = null;

        private var _node:int;
        private var _place:Object;
        private var _name:String;
        private var _labelOf:Function;

        /**
         * @param node the index of the node; -1 for none
         * @param mesh the mesh; all its instances share it
         * @param place the instance's place in the file, for errors
         * @param name the name of the model's mesh that it becomes; null for none
         * @param labelOf <code>function(material:String, materials:TriangleLabels):int</code>; returns the label of a primitive's material
         */
        public function MeshInstance(node:int, mesh:SceneMesh, place:Object, name:String, labelOf:Function)
        {
            _node = node;
            this.mesh = mesh;
            _place = place;
            _name = name;
            _labelOf = labelOf;
        }

        /** The steps that add the mesh, which is read, to a model in a scene's present pose. */
        public function adding(data:ModelData, scene:Scene):Steps
        {
            var toScene:AffineTransform = scene.transformOf(_node);
            if (deforming == null)
            {
                return placing(data, scene.budget, mesh.points, toScene, toScene.isMirror);
            }
            var deformed:DeformedPoints = new DeformedPoints(mesh.points, toScene);
            return new StepSequence().add(deforming(deformed)).begin(function():Steps
                {
                    return placing(data, scene.budget, deformed.points, deformed.toScene, deformed.isMirror);
                });
        }

        // The steps that add points and the triangles. If the mesh is mirrored in the scene, the triangles' corner order is reversed.
        private function placing(data:ModelData, budget:FileBudget, points:Vector.<Number>, toScene:AffineTransform, isMirror:Boolean):Steps
        {
            var firstVertex:int = data.vertices.length / 3;
            var firstTriangle:int = data.triangles.length / 3;
            var vertexCount:int = points.length / 3;
            budget.checkMeshSize(firstVertex + vertexCount, firstTriangle + mesh.triangleCount, _place);
            if (mesh.triangleCount > 0)
            {
                data.meshes.beginRun(data.meshes.addLabel(_name), firstTriangle);
            }
            return new StepSequence().slices(vertexCount, POINTS_PER_STEP, function(first:int, end:int):void
                {
                    refuseModelIf(!toScene.transformPoints(points, first, end, data.vertices, firstVertex + first), data.name,
                            "its vertices are not finite numbers, or are too large at its place", _place);
                }).beginEach(mesh.triangleCount > 0 ? mesh.primitives.length : 0, function(index:int):Steps
                {
                    data.materials.beginRun(_labelOf(mesh.materials[index], data.materials), data.triangles.length / 3);
                    return mesh.primitives[index](firstVertex, data.triangles);
                }).begin(function():Steps
                {
                    return isMirror ? reversingWinding(data.triangles, firstTriangle) : null;
                });
        }
    }
}
