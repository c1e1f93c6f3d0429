package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.shortened;
    import starlogo.steps.StepSequence;

    /** Visits the nodes of a COLLADA scene and finds their geometries. If there is no scene, it takes all geometries of the library. */
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
        private var _meshes:Object; // of geometries in the scene; the key is "#" and the geometry's id

        // The elements that are to be visited, the next one last. Null stands for the end of the innermost node.
        private var _pending:Vector.<ColladaElement> = new Vector.<ColladaElement>();

        // The scene and the nodes around the next element, each in the one before. What takes points of each to the scene grows with each of its
        // transform elements that is visited.
        private var _nodes:Vector.<ColladaElement> = new Vector.<ColladaElement>();
        private var _transforms:Vector.<AffineTransform> = new Vector.<AffineTransform>();

        /**
         * @param root the document's root element
         * @param pose moves the scene; null at rest
         */
        public function ColladaScene(root:ColladaElement, pose:ColladaPose)
        {
            _pose = pose;
            _meshes = pose == null ? {} : pose.figure.meshes;
            var scene:ColladaElement = root.child("scene");
            var instance:ColladaElement = scene == null ? null : scene.child("instance_visual_scene");
            if (instance != null)
            {
                enter(instance.target("url", ["visual_scene"]), new AffineTransform());
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
                visit(_pending.pop(), _nodes.length - 1);
            }
            return _pending.length > 0;
        }

        private function addLibrary(root:ColladaElement):void
        {
            for each (var library:ColladaElement in root.childrenNamed("library_geometries"))
            {
                for each (var geometry:ColladaElement in library.childrenNamed("geometry"))
                {
                    instances.push(new ColladaInstance(geometry, new ColladaMesh(geometry), new AffineTransform()));
                }
            }
        }

        // All elements of a node are visited next. @param transform takes points of what is around the node to the scene
        private function enter(node:ColladaElement, transform:AffineTransform):void
        {
            node.refuseIf(_nodes.length > MAX_DEPTH, "its nodes are nested more than " + MAX_DEPTH + " deep");
            node.limits.countElements(COUNT_PER_PLACING * (1 + node.children.length), node);
            _nodes.push(node);
            _transforms.push(transform);
            _pending.push(null);
            for (var i:int = node.children.length - 1; i >= 0; i--)
            {
                _pending.push(node.children[i]);
            }
        }

        // Visits an element of the innermost node, whose index is given.
        private function visit(element:ColladaElement, node:int):void
        {
            if (element == null)
            {
                leave(_nodes.pop(), _transforms.pop());
                return;
            }
            var transform:AffineTransform = _transforms[node];
            switch (element.name)
            {
                case "instance_geometry":
                    addInstance(element, element.target("url", ["geometry"]), transform);
                    break;
                case "instance_controller":
                    addController(element, transform);
                    break;
                case "instance_node":
                    var inner:ColladaElement = element.target("url", ["node"]);
                    element.refuseIf(_nodes.indexOf(inner) >= 0, "recursive instance_node: it places the node \"" + shortened(inner.id) + "\" within itself");
                    enter(inner, transform);
                    break;
                case "node":
                    enter(element, transform);
                    break;
                default:
                    var local:AffineTransform = _pose == null ? element.toTransform() : _pose.transformOf(element);
                    _transforms[node] = local == null ? transform : transform.after(local);
            }
        }

        private function leave(node:ColladaElement, transform:AffineTransform):void
        {
            if (_pose != null)
            {
                _pose.place(node, transform);
            }
        }

        // Follows controllers down to the geometry, and finds their skins and morphs.
        private function addController(element:ColladaElement, transform:AffineTransform):void
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
            if (_pose == null)
            {
                addInstance(element, target, bound(deformers, transform));
                return;
            }
            var mesh:ColladaMesh = meshOf(target);
            var deformation:ColladaDeformation = new ColladaDeformation(_pose, element, mesh, deformers);
            instances.push(new ColladaInstance(element, mesh, deformation.isSkinned ? new AffineTransform() : transform, deformation));
        }

        // At rest a skin stays where its bind shape matrix puts it. A morph is its base shape.
        private static function bound(deformers:Vector.<ColladaElement>, transform:AffineTransform):AffineTransform
        {
            for each (var deformer:ColladaElement in deformers)
            {
                var shape:ColladaElement = deformer.name == "skin" ? deformer.child("bind_shape_matrix") : null;
                transform = shape == null ? transform : transform.after(shape.toTransform());
            }
            return transform;
        }

        private function addInstance(element:ColladaElement, geometry:ColladaElement, transform:AffineTransform):void
        {
            instances.push(new ColladaInstance(element, meshOf(geometry), transform));
        }

        // Each geometry is read once, even if it is in the scene many times.
        private function meshOf(geometry:ColladaElement):ColladaMesh
        {
            return _meshes["#" + geometry.id] ||= new ColladaMesh(geometry, _pose != null);
        }
    }
}
