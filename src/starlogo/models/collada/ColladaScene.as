package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.FileLimits;
    import starlogo.models.text.TextWords;
    import starlogo.steps.StepSequence;

    /** Visits the nodes of a COLLADA scene and finds their geometries. If there is no scene, it takes all geometries of the library. */
    internal final class ColladaScene extends StepSequence
    {
        private static const ELEMENTS_PER_STEP:int = 100;
        private static const MAX_DEPTH:int = 256;
        private static const MAX_CONTROLLERS:int = 16;

        // a placed element takes more memory than an element
        private static const THINGS_PER_ELEMENT:int = 2;

        /** The geometries in the document's order, when no step is left. */
        public var instances:Vector.<ColladaPlace> = new Vector.<ColladaPlace>();

        private var _meshes:Object = {}; // of geometries in the scene; the key is "#" and the geometry's id

        // The elements that are to be visited, the next one last, and the node that each is in.
        private var _pending:Vector.<ColladaElement> = new Vector.<ColladaElement>();
        private var _nodes:Vector.<ColladaPlace> = new Vector.<ColladaPlace>();

        /**
         * @param root the document's root element
         * @param up turns the scene to z up
         */
        public function ColladaScene(root:ColladaElement, up:AffineTransform)
        {
            var scene:ColladaElement = root.child("scene");
            var instance:ColladaElement = scene == null ? null : scene.child("instance_visual_scene");
            if (instance != null)
            {
                enter(new ColladaPlace(instance.target("url", ["visual_scene"]), null, up));
                repeat(visitSome);
            }
            else
            {
                addLibrary(root, up);
            }
        }

        private function visitSome():Boolean
        {
            for (var i:int = 0; i < ELEMENTS_PER_STEP && _pending.length > 0; i++)
            {
                visit(_pending.pop(), _nodes.pop());
            }
            return _pending.length > 0;
        }

        private function addLibrary(root:ColladaElement, up:AffineTransform):void
        {
            for each (var library:ColladaElement in root.childrenNamed("library_geometries"))
            {
                for each (var geometry:ColladaElement in library.childrenNamed("geometry"))
                {
                    instances.push(new ColladaPlace(geometry, null, up, new ColladaMesh(geometry)));
                }
            }
        }

        // All elements of a node are visited next.
        private function enter(node:ColladaPlace):void
        {
            var children:Vector.<ColladaElement> = node.element.children;
            node.element.refuseIf(node.depth > MAX_DEPTH, "its nodes are nested more than " + MAX_DEPTH + " deep");
            node.element.limits.count(FileLimits.THINGS, THINGS_PER_ELEMENT * (1 + children.length), node.element);
            for (var i:int = children.length - 1; i >= 0; i--)
            {
                _pending.push(children[i]);
                _nodes.push(node);
            }
        }

        private function visit(element:ColladaElement, node:ColladaPlace):void
        {
            switch (element.name)
            {
                case "instance_geometry":
                    addInstance(element, element.target("url", ["geometry"]), node.transform);
                    break;
                case "instance_controller":
                    addController(element, node.transform);
                    break;
                case "instance_node":
                    var inner:ColladaElement = element.target("url", ["node"]);
                    element.refuseIf(node.isWithin(inner), "recursive instance_node: it places the node \"" + TextWords.shorten(inner.id) + "\" within itself");
                    enter(new ColladaPlace(inner, node, node.transform));
                    break;
                case "node":
                    enter(new ColladaPlace(element, node, node.transform));
                    break;
                default:
                    var local:AffineTransform = element.toTransform();
                    node.transform = local == null ? node.transform : node.transform.after(local);
            }
        }

        // Follows controllers down to the geometry. A skin stays where its bind shape matrix puts it. A morph is its base shape.
        private function addController(element:ColladaElement, transform:AffineTransform):void
        {
            var target:ColladaElement = element.target("url", ["controller"]);
            for (var i:int = 0; target.name == "controller"; i++)
            {
                element.limits.count(FileLimits.THINGS, THINGS_PER_ELEMENT, element);
                var skin:ColladaElement = target.child("skin");
                var deformer:ColladaElement = skin || target.requiredChild("morph");
                var shape:ColladaElement = skin == null ? null : skin.child("bind_shape_matrix");
                transform = shape == null ? transform : transform.after(shape.toTransform());
                target = deformer.target("source", ["geometry", "controller"]);
                element.refuseIf(i == MAX_CONTROLLERS, "more than " + MAX_CONTROLLERS +
                        " controllers follow one another, or they refer to each other in a circle");
            }
            addInstance(element, target, transform);
        }

        // Each geometry is read once, even if it is in the scene many times.
        private function addInstance(element:ColladaElement, geometry:ColladaElement, transform:AffineTransform):void
        {
            var mesh:ColladaMesh = _meshes["#" + geometry.id] ||= new ColladaMesh(geometry);
            instances.push(new ColladaPlace(element, null, transform, mesh));
        }
    }
}
