// Starts the main class of a SWF in avmshell, and runs its frames until it ends:
// avmshell FILE.swf start.abc -- MAIN [NAME=VALUE ...] [/path=FOLDER ...]
// Some of the lines that it traces begin with U+0001. They are for build/headless/shell.mjs: "write FILE TEXT", both escaped, is a file to
// write, "uncaught TEXT" is an error that nothing caught, and "exit STATUS" is the end.
import avmplus.Domain;
import avmplus.FLASH10_FLAGS;
import avmplus.File;
import avmplus.System;
import avmplus.describeType;
import avmplus.getQualifiedClassName;
import flash.utils.ByteArray;

var SIGN:String = String.fromCharCode(1);

var machine:* = Domain.currentDomain.getClass("standin.Machine");
var startedNs:Number = System.getNanosecondTimer();
var mounts:Array = [];
var timeouts:Array = [];
var timeoutCount:uint = 0;
var hasEnded:Boolean = false;
var status:int = 0;

machine.player = "Adobe's VM (avmshell " + System.getAvmplusVersion() + (System.getRunmode() == "mixed" ? "" : ", " + System.getRunmode()) + ")";

machine.now = function():Number
{
    return (System.getNanosecondTimer() - startedNs) / 1e6;
};

machine.timer = System.getTimer;

machine.setTimeout = function(callback:Function, ms:Number):uint
{
    timeouts.push({id: ++timeoutCount, call: callback, at: machine.now() + ms});
    return timeoutCount;
};

machine.clearTimeout = function(id:uint):void
{
    timeouts = timeouts.filter(function(timeout:Object, index:int, all:Array):Boolean
        {
            return timeout.id != id;
        });
};

machine.reportError = function(error:*):void
{
    var stack:String = error is Error ? error.getStackTrace() : null;
    print(SIGN + "uncaught " + escape(error + (stack ? "\n" + stack : "")));
};

machine.writeFile = function(file:String, text:String):void
{
    print(SIGN + "write " + escape(file) + " " + escape(text));
};

machine.exit = function(value:int):void
{
    hasEnded = true;
    status = value;
};

machine.memory = function():Number
{
    return System.totalMemory;
};

machine.collect = function():void
{
    // The first call finishes the collector's present cycle, which keeps new garbage. So there is a second call.
    System.forceFullCollection();
    System.forceFullCollection();
};

machine.className = getQualifiedClassName;

machine.definition = function(name:String):Object
{
    return Domain.currentDomain.getClass(name.split("::").join("."));
};

machine.describe = function(value:*):XML
{
    return describeType(value, FLASH10_FLAGS);
};

machine.readFile = function(url:String):ByteArray
{
    // the SWF is at the root, as in the player
    url = url.charAt(0) == "/" ? url : "/" + url;
    for each (var mount:Array in mounts)
    {
        var path:String = mount[1] + unescape(url.split("?")[0]).substr(mount[0].length);
        if (url.indexOf(mount[0] + "/") == 0 && File.exists(path))
        {
            return File.readByteArray(path);
        }
    }
    return null;
};

for (var i:int = 1; i < System.argv.length; i++)
{
    var equals:int = System.argv[i].indexOf("=");
    var name:String = System.argv[i].substr(0, equals);
    var given:String = System.argv[i].substr(equals + 1);
    if (name.charAt(0) == "/")
    {
        mounts.push([name, given]);
    }
    else
    {
        machine.parameters[name] = given;
    }
}
// the class, or null if the program does not contain it
function classOf(name:String):*
{
    try
    {
        return Domain.currentDomain.getClass(name);
    }
    catch (error:*)
    {
        return null;
    }
}

// Calls all timeouts that are due, the oldest first.
function callTimeouts():void
{
    var now:Number = machine.now();
    var due:Array = timeouts.filter(function(timeout:Object, index:int, all:Array):Boolean
        {
            return timeout.at <= now;
        });
    for each (var timeout:Object in due.sortOn(["at", "id"], Array.NUMERIC))
    {
        // an earlier one may have cancelled it
        if (timeouts.indexOf(timeout) >= 0)
        {
            timeouts.splice(timeouts.indexOf(timeout), 1);
            attempt(timeout.call);
        }
    }
}

function attempt(call:Function):void
{
    try
    {
        call();
    }
    catch (error:*)
    {
        machine.reportError(error);
    }
}

function enterFrame():void
{
    var Event:* = classOf("flash.events.Event");
    for each (var listener:* in machine.frameListeners.concat())
    {
        listener.dispatchEvent(new Event("enterFrame"));
    }
}

var Matrix:* = classOf("flash.geom.Matrix3D");
if (Matrix && machine.parameters["single"] == "true")
{
    Matrix.isSingle = true;
}

attempt(function():void
    {
        var DisplayObject:* = classOf("flash.display.DisplayObject");
        var Stage:* = classOf("flash.display.Stage");
        var Main:Class = Domain.currentDomain.getClass(System.argv[0]);
        DisplayObject.stageOfMain = new Stage();
        var main:* = new Main();
        var stage:* = DisplayObject.stageOfMain;
        DisplayObject.stageOfMain = null;
        stage.addChild(main);
    });

// frames follow one another at once
while (!hasEnded && (timeouts.length > 0 || machine.frameListeners.length > 0))
{
    callTimeouts();
    enterFrame();
    if (machine.frameListeners.length == 0)
    {
        System.sleep(1);
    }
}
if (hasEnded)
{
    print(SIGN + "exit " + status);
}
