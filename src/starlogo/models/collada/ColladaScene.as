package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.shortened;
    import starlogo.steps.StepSequence;

    /**
     * Visits the nodes of a COLLADA scene and finds their geometries, and where its nodes are. If there is no scene, it takes all geometries of
     * the library.
     */
    internal final class ColladaScene extends StepSequence
    {
        private static const ELEMENTS_PER_STEP:int = 100;
        private static const MAX_DEPTH:int = 256;
        private static const MAX_CONTROLLERS:int = 16;

        // a placed element takes more memory than an element
        private static const COUNT_PER_PLACING:int = 2;

        /** The geometries in the document's order, when no step is left. */
        public var instances:Vector.<ColladaInstance> = new Vector.<ColladaInstance>();

        private var _pose:ColladaPose;

        // The elements that are to be visited, the next one last. Null stands for the end of the innermost node.
        private var _pending:Vector.<ColladaElement> = new Vector.<ColladaElement>();

        // The innermost node around the next element, or the scene, and how many there were so far.
        private var _place:ColladaPlace = null;
        private var _placeCount:int = 0;

        /**
         * @param root the document's root element
         * @param pose moves the scene, and takes where its nodes are
         */
        public function ColladaScene(root:ColladaElement, pose:ColladaPose)
        {
            _pose = pose;
            var scene:ColladaElement = root.child("scene");
            var instance:ColladaElement = scene == null ? null : scene.child("instance_visual_scene");
            if (instance != null)
            {
                enter(instance.target("url", ["visual_scene"]));
                repeat(visitSome);
            }
            else
            {
                addLibrary(root);
            }
        }

        private function visitSome():Boolean
        {
            for (var i:int = 0; i < ELEMENTS_PER_STEP && _pending.length > 0; i++)
            {
                visit(_pending.pop());
            }
            return _pending.length > 0;
        }

        private function addLibrary(root:ColladaElement):void
        {
            for each (var library:ColladaElement in root.childrenNamed("library_geometries"))
            {
                for each (var geometry:ColladaElement in library.childrenNamed("geometry"))
                {
                    instances.push(new ColladaInstance(geometry, _pose.document.meshOf(geometry), new AffineTransform()));
                }
            }
        }

        // All elements of a node are visited next.
        private function enter(node:ColladaElement):void
        {
            _place = new ColladaPlace(node, _place, _placeCount++);
            node.refuseIf(_place.depth > MAX_DEPTH, "its nodes are nested more than " + MAX_DEPTH + " deep");
            node.limits.countElements(COUNT_PER_PLACING * (1 + node.children.length), node);
            _pose.addPlace(_place);
            _pending.push(null);
            for (var i:int = node.children.length - 1; i >= 0; i--)
            {
                _pending.push(node.children[i]);
            }
        }

        // Visits an element of the innermost node.
        private function visit(element:ColladaElement):void
        {
            if (element == null)
            {
                _place.end = _placeCount;
                _place = _place.around;
                return;
            }
            switch (element.name)
            {
                case "instance_geometry":
                    instances.push(new ColladaInstance(element, _pose.document.meshOf(element.target("url", ["geometry"])), _place.transform));
                    break;
                case "instance_controller":
                    addController(element);
                    break;
                case "instance_node":
                    var inner:ColladaElement = element.target("url", ["node"]);
                    element.refuseIf(_place.isWithin(inner), "recursive instance_node: it places the node \"" + shortened(inner.id) + "\" within itself");
                    enter(inner);
                    break;
                case "node":
                    enter(element);
                    break;
                default:
                    var local:AffineTransform = _pose.transformOf(element);
                    _place.transform = local == null ? _place.transform : _place.transform.after(local);
            }
        }

        // Follows controllers down to the geometry, and finds their skins and morphs.
        private function addController(element:ColladaElement):void
        {
            var deformers:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            var target:ColladaElement = element.target("url", ["controller"]);
            while (target.name == "controller")
            {
                element.limits.countElements(COUNT_PER_PLACING, element);
                var deformer:ColladaElement = target.child("skin") || target.requiredChild("morph");
                target = deformer.target("source", ["geometry", "controller"]);
                element.refuseIf(deformers.length == MAX_CONTROLLERS, "more than " + MAX_CONTROLLERS +
                        " controllers follow one another, or they refer to each other in a circle");
                deformers.push(deformer);
            }
            var mesh:ColladaMesh = _pose.document.meshOf(target);
            instances.push(new ColladaInstance(element, mesh, _place.transform, new ColladaDeformation(_pose, element, _place, mesh, deformers)));
        }
    }
}
