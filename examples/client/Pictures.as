package
{
    import flash.display.Shape;
    import flash.geom.ColorTransform;
    import flash.utils.Dictionary;
    import starlogo.agents.Agent;
    import starlogo.models.Model;

    /** What agents look like from above: their models' triangles that face upwards, from the lowest to the highest. */
    public class Pictures
    {
        private var _pixelsAPatch:Number;
        private var _drawings:Object = {};
        private var _pictures:Dictionary = new Dictionary();

        /** @param pixelsAPatch how large all of it is */
        public function Pictures(pixelsAPatch:Number)
        {
            _pixelsAPatch = pixelsAPatch;
        }

        /** Draws a model once, a hundred pixels wide and in white: agents that have its shape copy and colour it. */
        public function addModel(model:Model):void
        {
            var drawing:Shape = new Shape();
            for each (var face:Face in facesAbove(model))
            {
                face.draw(drawing.graphics);
            }
            _drawings[model.name] = drawing;
        }

        /** The picture of an agent, to be put on the stage. */
        public function pictureOf(agent:Agent):Shape
        {
            var picture:Shape = new Shape();
            picture.graphics.copyFrom(_drawings[agent.shape].graphics);
            picture.cacheAsBitmap = true;
            _pictures[agent] = picture;
            update(agent);
            return picture;
        }

        /** Puts an agent's picture where the agent is. */
        public function update(agent:Agent):void
        {
            var picture:Shape = _pictures[agent];
            picture.visible = agent.z >= 0;
            picture.x = _pixelsAPatch * agent.x;
            picture.y = -_pixelsAPatch * agent.y; // up on the stage is down in the world
            picture.rotation = -agent.heading;
            picture.scaleX = picture.scaleY = _pixelsAPatch * agent.size / Face.PIXELS;
            var color:uint = uint(agent.color);
            picture.transform.colorTransform = new ColorTransform((color >> 16) / 255, (color >> 8 & 255) / 255, (color & 255) / 255);
        }

        private function facesAbove(model:Model):Array
        {
            var faces:Array = [];
            for (var i:int = 0; i < model.triangles.length; i += 3)
            {
                var face:Face = new Face(model.vertices, model.triangles, i);
                if (face.up > 0)
                {
                    faces.push(face);
                }
            }
            return faces.sortOn("top", Array.NUMERIC);
        }
    }
}

import flash.display.Graphics;

/** A triangle seen from above. */
internal class Face
{
    public static const PIXELS:Number = 100;

    public var top:Number;
    public var up:Number;

    private var _x:Vector.<Number> = new Vector.<Number>(3);
    private var _y:Vector.<Number> = new Vector.<Number>(3);

    public function Face(vertices:Vector.<Number>, triangles:Vector.<uint>, first:int)
    {
        var z:Vector.<Number> = new Vector.<Number>(3);
        for (var i:int = 0; i < 3; i++)
        {
            var vertex:int = 3 * triangles[first + i];
            _x[i] = vertices[vertex];
            _y[i] = vertices[vertex + 1];
            z[i] = vertices[vertex + 2];
        }
        top = Math.max(z[0], z[1], z[2]);
        up = upOf(z);
    }

    /** Fills it: the steeper, the darker. A line of the same colour closes the seams between neighbours. */
    public function draw(graphics:Graphics):void
    {
        var shade:uint = 255 * (0.45 + 0.55 * up);
        var color:uint = shade << 16 | shade << 8 | shade;
        graphics.lineStyle(1, color);
        graphics.beginFill(color);
        graphics.moveTo(PIXELS * _x[2], -PIXELS * _y[2]);
        for (var i:int = 0; i < 3; i++)
        {
            graphics.lineTo(PIXELS * _x[i], -PIXELS * _y[i]);
        }
        graphics.endFill();
    }

    // how far its normal points up: 1 for what is level, less than 0 for what faces down
    private function upOf(z:Vector.<Number>):Number
    {
        var normalX:Number = (_y[1] - _y[0]) * (z[2] - z[0]) - (z[1] - z[0]) * (_y[2] - _y[0]);
        var normalY:Number = (z[1] - z[0]) * (_x[2] - _x[0]) - (_x[1] - _x[0]) * (z[2] - z[0]);
        var normalZ:Number = (_x[1] - _x[0]) * (_y[2] - _y[0]) - (_y[1] - _y[0]) * (_x[2] - _x[0]);
        return normalZ / (Math.sqrt(normalX * normalX + normalY * normalY + normalZ * normalZ) || 1);
    }
}
