package starlogo.models.collada
{
    import flash.geom.Vector3D;
    import starlogo.data.lastAtMost;
    import starlogo.geometry.AffineTransform;
    import starlogo.models.Model;
    import starlogo.models.ModelError;
    import starlogo.models.ModelTransform;
    import starlogo.models.building.FormatReader;
    import starlogo.models.building.ModelData;
    import starlogo.models.building.TriangleLabels;
    import starlogo.models.files.FileBudget;
    import starlogo.models.files.ModelFile;
    import starlogo.models.files.refuseModelIf;
    import starlogo.models.files.shortened;
    import starlogo.models.scene.MeshInstance;
    import starlogo.models.scene.Scene;
    import starlogo.models.scene.SceneMesh;
    import starlogo.models.text.TextWords;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Reads a COLLADA document. ColladaModel says which parts. Its steps visit the nodes of the scene, and find the instances of geometries. If there
     * is no scene, it takes all geometries of the library. Then the Scene adds them to the model.
     *
     * <p>An XmlReader makes ColladaElements of the text. The transforms of nodes come from ColladaTransforms. An element that other nodes instantiate is
     * several nodes of the Scene. Each geometry becomes a SceneMesh, with the points of ColladaAccessors and the triangles of ColladaPrimitives.</p>
     *
     * @private
     */
    public final class ColladaReader extends StepSequence implements FormatReader
    {
        private static const ELEMENTS_PER_STEP:int = 100;
        private static const MAX_DEPTH:int = 256;
        private static const MAX_CONTROLLERS:int = 16;

        // a node takes more memory than an element
        private static const ELEMENTS_PER_NODE:int = 2;

        /** The steps that read the document's elements. Read only. */
        internal var xml:XmlReader;

        /** The scene. Its steps read the document. Read only. */
        internal var scene:Scene;

        private var _data:ModelData;
        private var _meshes:Object = {}; // by the index of the geometry's element
        private var _skins:Object = {}; // by the index of the skin's element

        // the element of each node, and lists of an element's nodes, by the element's index
        private var _elements:Vector.<ColladaElement> = new Vector.<ColladaElement>();
        private var _nodes:Object = {};

        // The elements that are visited next, the last one first. The elements of the nodes around the present element, the outermost one first, and the
        // innermost one's node: -1 without a scene.
        private var _pending:Vector.<ColladaElement> = new Vector.<ColladaElement>();
        private var _around:Vector.<ColladaElement> = new Vector.<ColladaElement>();
        private var _node:int = -1;

        /**
         * @param file the document
         * @param upAxis "x", "y" or "z"; a ModelTransform leaves the document as it is; null for the axis that the document names
         * @param scaling as for Model's constructor; null if the vertices are not normalised
         */
        public function ColladaReader(file:ModelFile, upAxis:Object, scaling:String)
        {
            var text:String = file.requireText();
            var budget:FileBudget = new FileBudget(file.name, text.length);
            xml = new XmlReader(text, budget);
            _data = ModelData.forFile(file.name, upAxis, scaling, "y");
            scene = new Scene(_data, budget, transformOf);
            scene.add(xml).call(function():void
                {
                    readAsset(upAxis == null, scaling);
                    enterScene();
                }).repeat(visitSome).begin(readingMeshes);
            add(scene).begin(function():Steps
                {
                    return scene.adding(_data);
                });
        }

        /** @inheritDoc */
        public function get data():ModelData
        {
            return _data;
        }

        /** The root, when the elements are read. @throws ModelError if it is not COLLADA */
        internal function get root():ColladaElement
        {
            refuseModelIf(xml.root == null, _data.name, "this is not XML: expected a COLLADA document");
            xml.root.refuseIf(xml.root.name != "COLLADA", "expected a COLLADA document, but its root element is <" + xml.root.name + ">");
            return xml.root;
        }

        /** The children with a name of all libraries with a name. */
        internal function entriesOf(libraryName:String, name:String):Vector.<ColladaElement>
        {
            var entries:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            for each (var library:ColladaElement in root.childrenNamed(libraryName))
            {
                for each (var entry:ColladaElement in library.childrenNamed(name))
                {
                    entries.push(entry);
                }
            }
            return entries;
        }

        // The transform from a joint's node to the scene. A joint may have several nodes. The one with the lowest ancestor in common with the skin's node
        // counts, the first of several. So each of several figures has joints of its own.
        private function jointTransform(joint:ColladaElement, skinNode:int, skin:ColladaElement):AffineTransform
        {
            var nodes:Vector.<Number> = _nodes[joint.index];
            skin.refuseIf(nodes == null, "its joint \"" + shortened(joint.attribute("sid") || joint.id) + "\" is not in the scene");
            if (nodes.length == 1)
            {
                return scene.transformOf(nodes[0]); // looks for no ancestors, which may be many
            }
            // nodes have the order of the visit, so the lowest ancestor is that of the joint's last node before the skin's, or of the next one
            var before:int = lastAtMost(nodes, skinNode);
            var next:int = Math.min(before + 1, nodes.length - 1);
            var ancestor:int = Math.max(commonAncestor(nodes[before], skinNode), commonAncestor(nodes[next], skinNode));
            var first:int = lastAtMost(nodes, ancestor - 1);
            return scene.transformOf(nodes[first] < ancestor ? nodes[first + 1] : nodes[first]);
        }

        // The lowest node around two nodes, which may be one of these. Nodes come after those around them.
        private function commonAncestor(node:int, other:int):int
        {
            while (node != other)
            {
                if (node > other)
                {
                    node = scene.parents[node];
                }
                else
                {
                    other = scene.parents[other];
                }
            }
            return node;
        }

        // The up axis is y if none is named. A unit that is no length counts as a metre.
        private function readAsset(usesAxis:Boolean, scaling:String):void
        {
            var asset:ColladaElement = root.child("asset");
            var axis:ColladaElement = asset == null || !usesAxis ? null : asset.child("up_axis");
            var unit:ColladaElement = asset == null ? null : asset.child("unit");
            if (axis != null)
            {
                var named:String = TextWords.trimmed(axis.text);
                axis.refuseIf(!/^[XYZ]_UP$/.test(named), "expected X_UP, Y_UP or Z_UP, but found \"" + shortened(named) + "\"");
                _data.upAxis = named.charAt(0).toLowerCase();
            }
            var metres:Number = unit == null ? 1 : TextWords.toNumber(unit.attribute("meter"));
            if (scaling == Model.AS_GIVEN && _data.transform == null && metres > 0 && metres < Infinity && metres != 1)
            {
                _data.transform = new ModelTransform(null, new Vector3D(metres, metres, metres));
            }
        }

        private function enterScene():void
        {
            var shown:ColladaElement = root.child("scene");
            var instance:ColladaElement = shown == null ? null : shown.child("instance_visual_scene");
            if (instance != null)
            {
                enter(instance.target("url", ["visual_scene"]));
                return;
            }
            for each (var geometry:ColladaElement in entriesOf("library_geometries", "geometry"))
            {
                addInstance(geometry, geometry);
            }
        }

        private function visitSome():Boolean
        {
            for (var i:int = 0; i < ELEMENTS_PER_STEP && _pending.length > 0; i++)
            {
                var element:ColladaElement = _pending.pop();
                while (_around[_around.length - 1] != element.parent)
                {
                    _around.pop();
                    _node = scene.parents[_node];
                }
                visit(element);
            }
            return _pending.length > 0;
        }

        // The children of an element are visited next.
        private function enter(element:ColladaElement):void
        {
            scene.addNode(_node);
            _elements.push(element);
            _node = scene.parents.length - 1;
            (_nodes[element.index] ||= new Vector.<Number>()).push(_node);
            element.refuseIf(_around.push(element) > MAX_DEPTH + 1, "its nodes are nested more than " + MAX_DEPTH + " deep");
            element.budget.spendElements(ELEMENTS_PER_NODE * (1 + element.children.length), element);
            for (var i:int = element.children.length - 1; i >= 0; i--)
            {
                _pending.push(element.children[i]);
            }
        }

        // The transform from a node to the scene, by the transforms in its element. @param around that of the node around it
        private function transformOf(node:int, around:AffineTransform):AffineTransform
        {
            for each (var child:ColladaElement in _elements[node].children)
            {
                var numbers:Vector.<Number> = posed(child);
                var local:AffineTransform = numbers == null ? child.toTransform() : ColladaTransform.of(child, numbers);
                around = local == null ? around : around.after(local);
            }
            return around;
        }

        // The numbers of an element in the present pose, whose targets are the elements' indices; null if they are its own.
        private function posed(element:ColladaElement):Vector.<Number>
        {
            return scene.pose == null ? null : scene.pose.numbersOf(String(element.index));
        }

        // Visits a child of the present node's element.
        private function visit(element:ColladaElement):void
        {
            switch (element.name)
            {
                case "instance_geometry":
                    addInstance(element, element.target("url", ["geometry"]));
                    break;
                case "instance_controller":
                    addController(element);
                    break;
                case "instance_node":
                    var inner:ColladaElement = element.target("url", ["node"]);
                    element.refuseIf(_around.indexOf(inner) >= 0, "recursive instance_node: it places the node \"" + shortened(inner.id) + "\" within itself");
                    enter(inner);
                    break;
                case "node":
                    enter(element);
                    break;
                default:
                    // a transform that is wrong is refused, even if nothing is at its node
                    element.toTransform();
            }
        }

        // Follows controllers down to the geometry, and finds their skins and morphs.
        private function addController(element:ColladaElement):void
        {
            var chain:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            var target:ColladaElement = element.target("url", ["controller"]);
            while (target.name == "controller")
            {
                element.budget.spendElements(ELEMENTS_PER_NODE, element);
                var deformer:ColladaElement = target.child("skin") || target.requiredChild("morph");
                target = deformer.target("source", ["geometry", "controller"]);
                element.refuseIf(chain.length == MAX_CONTROLLERS, "more than " + MAX_CONTROLLERS +
                        " controllers follow one another, or they refer to each other in a circle");
                chain.push(deformer);
                if (deformer.name == "skin")
                {
                    _skins[deformer.index] ||= new ColladaSkin(deformer);
                }
            }
            var node:int = _node;
            var instance:MeshInstance = addInstance(element, target);
            instance.deforming = function(points:Vector.<Number>):Steps
            {
                return deforming(instance, element, chain, node, points);
            };
        }

        // The steps that move the points of an instance by a chain of skins and morphs. The last one moves them first. At rest the points are where they were
        // bound if a skin is wrong, or too much for the limits: what does not move needs no joints.
        private function deforming(instance:MeshInstance, element:ColladaElement, chain:Vector.<ColladaElement>, node:int, points:Vector.<Number>):Steps
        {
            var work:StepSequence = new StepSequence().beginEach(chain.length, function(index:int):Steps
                {
                    var deformer:ColladaElement = chain[chain.length - 1 - index];
                    return deformer.name == "skin" ? skinning(instance, element, _skins[deformer.index], node, points) : morphing(instance, deformer, points);
                });
            return new StepSequence().repeat(function():Boolean
                {
                    try
                    {
                        return work.step();
                    }
                    catch (error:ModelError)
                    {
                        if (scene.pose != null)
                        {
                            throw error;
                        }
                        bind(instance, chain, scene.transformOf(node), points);
                    }
                    return false;
                });
        }

        // Puts the points of an instance where its skins were bound. @param transform the node's
        private function bind(instance:MeshInstance, chain:Vector.<ColladaElement>, transform:AffineTransform, points:Vector.<Number>):void
        {
            for each (var deformer:ColladaElement in chain)
            {
                transform = deformer.name == "skin" ? transform.after(_skins[deformer.index].bindShape) : transform;
            }
            for (var i:int = 0; i < points.length; i++)
            {
                points[i] = instance.mesh.points[i];
            }
            instance.putAt(transform, transform.isMirror);
        }

        private function skinning(instance:MeshInstance, element:ColladaElement, skin:ColladaSkin, node:int, points:Vector.<Number>):Steps
        {
            return new StepSequence().add(skin).begin(function():Steps
                {
                    var count:int = skin.influences.offsets.length - 1;
                    skin.element.refuseIf(points.length != 3 * count, "it has weights for " + count + " points, but its geometry has " + points.length / 3);
                    return instance.skinning(points, skin.influences, skin.jointMatricesOf(jointTransform, node, element), skin.element);
                });
        }

        // At rest a morph is its base shape. The targets of a relative morph are added. Other targets share the shape with the base, whose weight is the rest.
        private function morphing(instance:MeshInstance, morph:ColladaElement, points:Vector.<Number>):Steps
        {
            if (scene.pose == null)
            {
                return new StepSequence();
            }
            var inputs:ColladaElement = morph.requiredChild("targets");
            var targets:ColladaAccessor = ColladaAccessor.read(inputs, "MORPH_TARGET", ColladaAccessor.NAMES, morph);
            var list:ColladaAccessor = ColladaAccessor.read(inputs, "MORPH_WEIGHT", ["float_array"], morph);
            var numbers:Vector.<Number> = posed(list.array);
            var weights:Vector.<Number> = numbers == null ? list.toNumbers() : list.partOf(numbers);
            morph.refuseIf(targets.words.length > list.count, "it has " + targets.words.length + " targets, but " + list.count + " weights");
            var base:Vector.<Number> = morph.attribute("method") == "RELATIVE" ? null : points.slice();
            return new StepSequence().beginEach(targets.words.length, function(index:int):Steps
                {
                    var id:String = shortened(targets.words[index]);
                    var geometry:ColladaElement = morph.elementAt("geometry", "#" + targets.words[index]);
                    morph.refuseIf(geometry == null, "there is no <geometry> with the id \"" + id + "\"");
                    var target:SceneMesh = meshOf(geometry);
                    return new StepSequence().add(target).begin(function():Steps
                        {
                            morph.refuseIf(target.points.length != points.length, "its target \"" + id + "\" has another number of points");
                            return instance.morphing(points, 0, weights[index * list.stride], target.points, base);
                        });
                });
        }

        private function meshOf(geometry:ColladaElement):SceneMesh
        {
            return _meshes[geometry.index] ||= ColladaPrimitive.meshOf(geometry);
        }

        // Adds an instance of a geometry, as a mesh with the name of its node. @param element places it; the geometry itself without a scene
        private function addInstance(element:ColladaElement, geometry:ColladaElement):MeshInstance
        {
            var name:String = nameOf(element == geometry ? geometry : element.parent) || nameOf(geometry);
            var instance:MeshInstance = new MeshInstance(scene, _node, meshOf(geometry), element, name, function(symbol:String, materials:TriangleLabels):int
                {
                    return labelOf(element, symbol, materials);
                });
            scene.instances.push(instance);
            return instance;
        }

        // The label of the material that an instance binds to a symbol. A symbol that is not bound counts as a material. -1 for no symbol.
        private static function labelOf(instance:ColladaElement, symbol:String, materials:TriangleLabels):int
        {
            instance.budget.spendElements(1, instance);
            if (symbol == "")
            {
                return -1;
            }
            var binding:ColladaElement = instance.child("bind_material");
            var technique:ColladaElement = binding == null ? null : binding.child("technique_common");
            var bound:ColladaElement = technique == null ? null : technique.child("instance_material", symbol);
            // null if none is bound, or one that is not in this file
            var material:ColladaElement = bound == null ? null : instance.elementAt("material", bound.attribute("target"));
            // a symbol may be equal to another material's id
            return material == null ? materials.labelWithKey("symbol " + symbol, symbol) : materials.labelWithKey("material " + material.id, nameOf(material));
        }

        private static function nameOf(element:ColladaElement):String
        {
            return element.attribute("name") || element.id || null;
        }

        // All geometries come first, so skins only have what these leave of the limits.
        private function readingMeshes():Steps
        {
            var count:int = scene.instances.length;
            return new StepSequence().beginEach(count, function(index:int):Steps
                {
                    _data.readProgress = index / count / 2;
                    return scene.instances[index].mesh;
                });
        }
    }
}
