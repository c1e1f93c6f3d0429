package starlogo.models.scene
{
    import flash.errors.IllegalOperationError;
    import starlogo.geometry.AffineTransform;
    import starlogo.models.building.ModelBuilder;
    import starlogo.models.building.ModelData;
    import starlogo.models.building.ModelReader;
    import starlogo.models.building.removingUnusedVertices;
    import starlogo.models.files.FileBudget;
    import starlogo.models.files.refuseModelIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * The scene of a COLLADA document or a glTF file: nodes, and instances of meshes at nodes. It has a subclass for each format, whose steps read it. Then
     * its meshes are added to a model, at rest by <code>building()</code>, or again and again in the poses of an animation.
     *
     * @private
     */
    public class Scene extends ModelReader
    {
        /** What the file may have and cost. Read only. */
        public var budget:FileBudget;

        /** The instances of meshes, in the order of the scene. The steps add them. */
        public var instances:Vector.<MeshInstance> = new Vector.<MeshInstance>();

        /** The node around each node; -1 for none. The steps set it. */
        public var parents:Vector.<int> = new Vector.<int>();

        // Numbers of the file that the present pose replaces: all of each target; null at rest.
        private var _pose:Object = null;

        // the transform of each node in the present pose; null before it is first needed
        private var _transforms:Vector.<AffineTransform> = new Vector.<AffineTransform>();

        /**
         * @param budget what the file may have and cost
         * @param upAxis "x", "y" or "z"; a ModelTransform leaves the file as it is; null for the file's
         * @param scaling as for Model's constructor; null if the vertices are not normalised
         */
        public function Scene(budget:FileBudget, upAxis:Object, scaling:String)
        {
            super(budget.modelName, upAxis, scaling, "y");
            this.budget = budget;
        }

        /** @inheritDoc The meshes are added to the model at rest. */
        override public function building():ModelBuilder
        {
            begin(function():Steps
                {
                    return adding(data);
                });
            return super.building();
        }

        /** Adds a node, and returns its index. @param parent the node around it; -1 for none, or if that is set later */
        public function addNode(parent:int):int
        {
            _transforms.push(null);
            return parents.push(parent) - 1;
        }

        /**
         * The transform from a node to the scene, in the present pose. @param node its index; -1 for the scene itself
         *
         * @throws ModelError if a transform is wrong, or the node contains itself
         */
        public function transformOf(node:int):AffineTransform
        {
            var chain:Vector.<int> = new Vector.<int>();
            for (var i:int = node; i >= 0 && _transforms[i] == null; i = parents[i])
            {
                refuseModelIf(chain.length > parents.length, data.name, "it contains itself", "nodes[" + node + "]");
                chain.push(i);
            }
            var transform:AffineTransform = i < 0 ? new AffineTransform() : _transforms[i];
            while (chain.length > 0)
            {
                i = chain.pop();
                transform = transformIn(i, transform);
                _transforms[i] = transform;
            }
            return transform;
        }

        /** The transform from a node to the scene, in the present pose. Each format implements it. @param around the transform of the node around it */
        protected function transformIn(node:int, around:AffineTransform):AffineTransform
        {
            throw new IllegalOperationError("a scene does not implement transformIn");
        }

        /**
         * The steps that read all meshes, if that was not done yet, and then add all instances to a model, in the present pose. All meshes come first, so
         * skins only have what these leave of the limits.
         */
        public function adding(model:ModelData):Steps
        {
            var scene:Scene = this;
            var count:int = instances.length;
            return new StepSequence().beginEach(count, function(index:int):Steps
                {
                    progress = index / count / 2;
                    return instances[index].mesh;
                }).beginEach(count, function(index:int):Steps
                {
                    progress = (1 + index / count) / 2;
                    return instances[index].adding(model, scene);
                }).call(function():void
                {
                    progress = 1;
                    refuseModelIf(model.vertices.length == 0, model.name, "no vertices: expected a mesh in the scene");
                }).add(removingUnusedVertices(model.vertices, model.triangles));
        }

        /** Whether the scene is in a pose of an animation. Otherwise it is at rest. */
        public function get isPosed():Boolean
        {
            return _pose != null;
        }

        /** All numbers of a target in the present pose: see AnimationChannel. Null if they are those in the file. */
        public function posed(target:String):Vector.<Number>
        {
            return _pose == null ? null : _pose[target];
        }

        /**
         * Brings the nodes into a pose. What the file may cost counts anew, because its meshes are placed once more.
         *
         * @param pose all numbers of each target that moves, by the target
         */
        public function setPose(pose:Object):void
        {
            _pose = pose;
            for (var i:int = 0; i < _transforms.length; i++)
            {
                _transforms[i] = null;
            }
            budget.reset();
        }
    }
}
