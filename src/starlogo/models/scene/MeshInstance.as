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
        private static const CORNERS_PER_STEP:int = 15000;

        /** The mesh. Read only. */
        public var mesh:SceneMesh;

        /** The morphs and skins: <code>function(deformed:DeformedPoints):Steps</code>; returns the steps that move the points. Null for none. */
        public var deforming:Function = null;

        private var _node:int;
        private var _place:Object;
        private var _name:String;

        /**
         * @param node the index of the node; -1 for none
         * @param mesh the mesh; all its instances share it
         * @param place the instance's place in the file, for errors
         * @param name the name of the model's mesh that it becomes; null for none
         */
        public function MeshInstance(node:int, mesh:SceneMesh, place:Object, name:String)
        {
            _node = node;
            this.mesh = mesh;
            _place = place;
            _name = name;
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
            var corners:Vector.<uint> = mesh.corners;
            var triangles:Vector.<uint> = data.triangles;
            budget.checkMeshSize(firstVertex + vertexCount, firstTriangle + corners.length / 3, _place);
            if (corners.length > 0)
            {
                addLabels(data, firstTriangle);
            }
            return new StepSequence().slices(vertexCount, POINTS_PER_STEP, function(first:int, end:int):void
                {
                    refuseModelIf(!toScene.transformPoints(points, first, end, data.vertices, firstVertex + first), data.name,
                            "its vertices are not finite numbers, or are too large at its place", _place);
                }).slices(corners.length, CORNERS_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        triangles.push(firstVertex + corners[i]);
                    }
                }).begin(function():Steps
                {
                    return isMirror ? reversingWinding(triangles, firstTriangle) : null;
                });
        }

        // Labels the triangles, which are added next.
        private function addLabels(data:ModelData, firstTriangle:int):void
        {
            data.meshes.beginRun(data.meshes.addLabel(_name), firstTriangle);
            for (var i:int = 0; i < mesh.materials.length; i++)
            {
                data.materials.beginRun(mesh.labelOf(mesh.materials[i], _place, data.materials), firstTriangle + mesh.firstTriangles[i]);
            }
        }
    }
}
